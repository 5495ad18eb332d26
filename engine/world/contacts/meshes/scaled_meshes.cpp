#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/contacts/contact_functions.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace graze {
namespace {

/// Products of five lengths stay within 2^-1000 to 2^1000 while lengths are within 2^-200 to 2^200;
/// differences of coordinates may be smaller than these by some 50 bits.
constexpr int kLargestExponent = 150;

int exponent_of(const PlacedMeshView& a, const PlacedMeshView& b) {
  double largest = 0;
  for (const PlacedMeshView* placed : {&a, &b}) {
    for (const double coordinate : largest_coordinates(placed->pose, placed->mesh.bounds()))
      largest = std::max(largest, coordinate);
  }
  return largest > 0 ? std::ilogb(largest) : 0;
}

PlacedShape scaled(const PlacedMeshView& placed, int exponent) {
  std::vector<Eigen::Vector3d> vertices(placed.mesh.vertices().begin(),
                                        placed.mesh.vertices().end());
  for (Eigen::Vector3d& vertex : vertices) {
    for (int k = 0; k < 3; ++k)
      vertex.data()[k] = std::ldexp(vertex.data()[k], exponent);
  }
  PlacedShape result{placed.mesh.deformed(vertices), placed.pose};
  for (int k = 12; k < 15; ++k)
    result.pose.data()[k] = std::ldexp(result.pose.data()[k], exponent);
  return result;
}

}  // namespace

bool candidates_of_scaled_meshes(const PlacedShapeView& a, const PlacedShapeView& b,
                                 ContactCandidates& candidates, Work& work) {
  const PlacedMeshView mesh_a{*a.shape.as<Mesh>(), a.pose};
  const PlacedMeshView mesh_b{*b.shape.as<Mesh>(), b.pose};
  const int exponent = exponent_of(mesh_a, mesh_b);
  if (std::abs(exponent) <= kLargestExponent) return false;
  const PlacedShape scaled_a = scaled(mesh_a, -exponent);
  const PlacedShape scaled_b = scaled(mesh_b, -exponent);
  candidates_of_meshes(scaled_a, scaled_b, candidates, work);
  for (int k = 0; k < 3; ++k)
    candidates.origin.data()[k] = std::ldexp(candidates.origin.data()[k], exponent);
  const auto back = [&](narrowphase::Vec3 v) {
    return narrowphase::Vec3{std::ldexp(v.x, exponent), std::ldexp(v.y, exponent),
                             std::ldexp(v.z, exponent)};
  };
  for (narrowphase::ContactPoint& point : candidates.list) {
    point.point_a = back(point.point_a);
    point.point_b = back(point.point_b);
    point.depth = std::ldexp(point.depth, exponent);
  }
  return true;
}

}  // namespace graze
