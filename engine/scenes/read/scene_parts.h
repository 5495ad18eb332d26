#pragma once

// Reads the parts of a scene. Private to engine/scenes.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/scenes/read/scene_units.h>
#include <graze/engine/scenes/scene.h>

namespace graze::scenes {

/// Reads files of one folder; meshes are loaded once however often a scene names them.
class MeshFiles {
 public:
  explicit MeshFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Reads a mesh by {"file", "unit", "sha256"}.
  Mesh read(const cases::JsonCursor& at);

  /// Returns all bytes of what "file" names, if they have the "sha256" that may be there.
  std::string read_bytes(const cases::JsonCursor& at);

 private:
  std::filesystem::path find(const cases::JsonCursor& at);

  std::filesystem::path folder_;
  std::map<std::pair<std::string, std::string>, Mesh> loaded_;  ///< the meshes by path and unit
  std::unordered_map<std::string, std::string> hashes_;         ///< the hashes by path
};

/// Keeps names and where they stand in their list.
class NameTable {
 public:
  explicit NameTable(const char* what) : what_(what) {}

  /// Adds a new name; throws for one that is empty or there already.
  std::string add(const cases::JsonCursor& at);

  /// Returns the index of a name that is there.
  std::size_t find(const cases::JsonCursor& at) const;

 private:
  const char* what_;
  std::unordered_map<std::string, std::size_t> indices_;
};

/// Reads the one shape that an object with a name describes.
Shape read_scene_shape(const cases::JsonCursor& at, const SceneUnits& units, MeshFiles& files);

/// Reads a terrain, of heights in the file or in another one.
HeightField read_height_field(const cases::JsonCursor& at, const SceneUnits& units,
                              MeshFiles& files);

SceneBody read_body(const cases::JsonCursor& at, const SceneUnits& units, const Scene& scene,
                    const NameTable& shapes);

/// Returns a direction of length 1, given by a vector of any other.
Eigen::Vector3d read_direction(const cases::JsonCursor& at);

}  // namespace graze::scenes
