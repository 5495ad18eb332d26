#pragma once

#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <tests/oracle/shapes.h>

#include "tests/benchmark/error/contestant.h"
#include "tests/benchmark/error/mesh_contestant.h"

namespace graze::benchmark {

using oracle::TriangleAndBox;
using oracle::TrianglePair;

struct SphereAndBox {
  Sphere sphere;
  Aabb box;
};

struct SpherePair {
  Sphere a;
  Sphere b;
};

/// All contestants by question. An adaptor adds to those that its library can answer.
struct Field {
  Contestants<TrianglePair> triangle_pairs;
  Contestants<TriangleAndBox> triangle_boxes;
  Contestants<SphereAndBox> sphere_boxes;
  Contestants<SpherePair> sphere_pairs;
  MeshContestants meshes;
};

}  // namespace graze::benchmark
