#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

#include <filesystem>
#include <string>
#include <vector>

namespace graze::samples {

/// Holds a mesh, what the file calls it, and its colour: red, green, blue from 0 to 1, linear.
struct GltfShape {
  std::string name;
  Mesh mesh;
  std::array<double, 3> colour;
};

/// Holds a shape in a pose, or in one after the other: in `poses[i]` at `times[i]`. With one pose
/// it stands still.
struct GltfBody {
  std::size_t shape;
  std::vector<Pose> poses;
};

/// Holds what a file of animated glTF 2.0 does: each shape once, a node for each body, and for each
/// that moves two channels, its translation and its rotation.
struct GltfScene {
  std::vector<GltfShape> shapes;
  std::vector<GltfBody> bodies;
  std::vector<double> times;  ///< seconds, ascending
};

/// Writes one file with its buffer in it. Throws graze::Error that names the file if it cannot be
/// written, InputError for a body without as many poses as times, or of no shape.
void write_gltf(const std::filesystem::path& path, const GltfScene& scene);

}  // namespace graze::samples
