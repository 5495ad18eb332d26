#pragma once

#include <graze/graze.h>

#include <cstdint>
#include <string>
#include <vector>

namespace graze::tests {

/// Where the way in which a thread computes shows.
enum class Scale {
  Denormal,  ///< all coordinates are
  Smallest,  ///< normal numbers whose differences are not
  Tiny,      ///< so are their products
  Unit       ///< turned lattices: rounding decides what touches
};
inline constexpr Scale kScales[] = {Scale::Denormal, Scale::Smallest, Scale::Tiny, Scale::Unit};

/// Numbers that questions are asked about, so that nothing is computed beside what is asked.
struct Inputs {
  std::vector<Eigen::Vector3d> vertices_a, vertices_b, bent;  ///< of tetrahedra
  std::vector<TriangleIndices> triangles_a, triangles_b;
  Pose pose_a, pose_b;
  std::vector<Pose> poses;
  Triangle triangle_a, triangle_b;
  std::vector<Triangle> triangles;
  Aabb box_a, box_b;
  std::vector<Aabb> boxes, boxes_later;
  Obb obb_a, obb_b;
  Sphere ball_a, ball_b;
  Ellipsoid ellipsoid;
  Ray ray;
  Eigen::Vector3d point, direction;
  double clearance;
  std::vector<Eigen::Vector3d> hull_points;  ///< of a size that shapes may have
  std::vector<Pose> body_poses;              ///< likewise
  std::string pose_text;
};

Inputs inputs_of(Scale scale, std::uint64_t seed, std::size_t tetrahedra);

/// A closed surface of 12 n^2 triangles, of which tasks of several threads are made.
Inputs large_inputs(Scale scale, int n);

}  // namespace graze::tests
