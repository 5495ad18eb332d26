#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

namespace graze::cli {

/// Holds a file of glTF 2.0 in its binary form, GLB, as it grows: JSON that says what is where in
/// one buffer. Numbers are floats.
class GltfFile {
 public:
  GltfFile();

  /// Adds a mesh and returns its number.
  std::size_t add_mesh(std::span<const Eigen::Vector3d> vertices,
                       std::span<const TriangleIndices> triangles, std::size_t material);
  /// Adds a matt colour, red, green and blue from 0 to 1, and returns its number.
  std::size_t add_material(const Eigen::Vector3f& colour);

  /// Adds a node at a pose and returns its number.
  std::size_t add_node(const std::string& name, const Pose& pose,
                       std::optional<std::size_t> mesh = {},
                       const std::vector<std::size_t>& children = {});

  /// Adds seconds, ascending, for the channels that follow. Returns the number of the accessor.
  std::size_t add_times(std::span<const float> seconds);
  /// Adds the translation and rotation of a node at these times, straight and the shorter way in
  /// between.
  void add_motion(std::size_t node, std::size_t times, std::span<const Pose> poses);
  /// Adds from which times on a node is seen, 1, or is not, 0.
  void add_presence(std::size_t node, std::size_t times, std::span<const float> is_seen);

  /// Returns the whole file: these nodes stand in one that turns z, which is up, to glTF's y.
  /// Throws InputError for more than a GLB can have, 4 GiB.
  std::string bytes(const std::vector<std::size_t>& nodes, const std::string& note);

 private:
  std::size_t add_floats(std::span<const float> numbers, std::size_t width, bool has_bounds);
  nlohmann::json begin(const void* numbers, std::size_t bytes, std::size_t count, int type,
                       const char* shape);
  void say_target(int target);
  std::size_t end(nlohmann::json accessor);
  void add_channel(std::size_t node, const char* path, std::size_t times, std::size_t values,
                   const char* interpolation);

  nlohmann::json file_;
  nlohmann::json animation_;
  std::string buffer_;
};

}  // namespace graze::cli
