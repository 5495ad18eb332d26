#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

#include <filesystem>
#include <string>
#include <vector>

namespace graze::samples {

/// Holds what came of a simulation: bodies of a few kinds in a bin, and how they came there.
struct Pile {
  struct Kind {
    std::string name;
    Mesh mesh;
  };
  struct Body {
    std::size_t kind;
    Pose pose;
    std::size_t first_frame;   ///< the time at which the body started
    std::vector<Pose> frames;  ///< its poses, one for each time from there on
  };

  std::string title;
  Mesh bin;
  double bin_height;  ///< metres
  std::vector<Kind> kinds;
  std::vector<Body> bodies;
  std::vector<double> times;  ///< seconds
};

/// Writes the motion as glTF. Throws as write_gltf() does.
void write_animation(const std::filesystem::path& path, const Pile& pile);

/// Writes the end as a scene for samples/draw: the bin cut open, and from above.
void write_picture(const std::filesystem::path& path, const Pile& pile);

}  // namespace graze::samples
