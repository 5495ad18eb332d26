#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/world/shape.h>

#include <string>
#include <vector>

#include "samples/simulation/mass_properties.h"

namespace graze::benchmark {

/// What many bodies of a scene share.
struct Kind {
  Shape shape;
  samples::MassProperties mass;
  double bounding_radius;  // metres from the centre of mass
};

/// Bodies over a mesh that does not move.
struct Scene {
  std::string name;
  Mesh ground;
  std::vector<Kind> kinds;
  std::vector<std::size_t> bodies;  // the kind of each
  std::size_t layer;                // so many are poured at once
  double radius;                    // metres: of the disc over which they are poured
  double seconds;                   // simulated until the frames begin, after the last was poured
};

/// A pose for each body.
using Frame = std::vector<Pose>;

Scene make_pile(std::size_t count, const std::string& data);
Scene make_pour(std::size_t count, const std::string& data);

}  // namespace graze::benchmark
