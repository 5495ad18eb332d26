#pragma once

#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <tests/oracle/shapes.h>

#include "tests/benchmark/error/contestant.h"
#include "tests/benchmark/error/mesh_contestant.h"
#include "tests/benchmark/error/mesh_distance_contestant.h"
#include "tests/benchmark/motion_queries/queries.h"

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

struct ObbPair {
  Obb a;
  Obb b;
};

/// Two triangles whose k-DOPs are asked about: each contestant fits its own, untimed.
struct KDopPair {
  Triangle a;
  Triangle b;
};

/// All contestants by question. An adaptor adds to those that its library can answer.
struct Field {
  Contestants<TrianglePair> triangle_pairs;
  Contestants<TriangleAndBox> triangle_boxes;
  Contestants<SphereAndBox> sphere_boxes;
  Contestants<SpherePair> sphere_pairs;
  Contestants<ObbPair> obb_pairs;
  Contestants<KDopPair> kdop_pairs;
  Contestants<MotionQuery> moving_points;  ///< and triangles, on straight paths
  Contestants<MotionQuery> moving_edges;   ///< pairs of them
  MeshContestants meshes;
  Contestants<TrianglePair, double> distances;  ///< of triangles, metres
  MeshDistanceContestants mesh_distances;
};

}  // namespace graze::benchmark
