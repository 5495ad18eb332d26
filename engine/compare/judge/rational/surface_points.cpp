#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>

#include <algorithm>
#include <array>
#include <limits>

namespace graze::compare {
namespace {

double most_along(const std::vector<Triangle>& triangles, const Eigen::Vector3d& n) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Triangle& t : triangles)
    most = std::max({most, n.dot(t.a), n.dot(t.b), n.dot(t.c)});
  return most;
}

}  // namespace

double distance_to(const std::vector<Triangle>& surface, const Eigen::Vector3d& p) {
  const std::array<Triangle, 1> point = {Triangle{p, p, p}};
  const RationalTriangle exact_point = exactly(point[0]);
  const auto distance = [&](std::uint32_t i) {
    return rounded_root(squared_distance(exactly(surface[i]), exact_point));
  };
  double least = distance(0);
  BoxTree::for_each_nearer(BoxTree(surface), BoxTree(point), least * (1 + 0x1p-50),
                           [&](std::uint32_t i, std::uint32_t) {
                             least = std::min(least, distance(i));
                             return least * (1 + 0x1p-50);
                           });
  return least;
}

double largest_coordinate(const MeshReferee& referee) {
  double largest = 0;
  for (const std::vector<Triangle>* triangles : {&referee.triangles_a(), &referee.triangles_b()}) {
    for (const Triangle& t : *triangles) {
      largest = std::max({largest, t.a.cwiseAbs().maxCoeff(), t.b.cwiseAbs().maxCoeff(),
                          t.c.cwiseAbs().maxCoeff()});
    }
  }
  return largest;
}

double overlap_along(const MeshReferee& referee, const Eigen::Vector3d& n) {
  return most_along(referee.triangles_a(), n) + most_along(referee.triangles_b(), -n);
}

}  // namespace graze::compare
