#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <graze/bvh/error.h>
#include <graze/engine/scenes/scene.h>

namespace graze {

/// Holds what reading needs to know beside the file.
struct ReadSceneSettings {
  /// The folder of the meshes that a scene names by file; if it is empty, that is the folder of the
  /// scene.
  std::filesystem::path mesh_folder = {};
};

/// Reads a scene, format version 1 (data/README.md, data/scene.schema.json). Throws SceneError
/// `file:line: /place: why` for an invalid scene: unknown and repeated keys, wrong types, numbers
/// that are not finite, names that stand twice or for nothing, poses that are not rigid, shapes
/// that the library refuses, files that are missing or outside of the folder. A scene refers to
/// mesh files and its own shapes alone, so that there are no circles; each file is loaded once.
/// Takes linear time and memory, but for hulls, which may have kMaxHullPoints points each.
Scene read_scene(const std::filesystem::path& path, const ReadSceneSettings& settings = {});

/// Reads a scene from memory as read_scene() does from a file; errors begin with `name`.
Scene parse_scene(std::string_view bytes, const std::string& name,
                  const ReadSceneSettings& settings = {});

/// The most steps that a scene may ask for.
inline constexpr std::size_t kMaxSceneSteps = 10'000'000;

}  // namespace graze
