#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/judge/pair_error.h>
#include <graze/engine/compare/judge/rational_triangle.h>
#include <graze/engine/compare/judge/witness_check.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace graze::compare {
namespace {

/// Of the size of a pair: engines in float add up some tens of roundings of 6e-8.
constexpr double kFloatTolerance = 1e-5;

Triangle point_triangle(const Eigen::Vector3d& p) {
  return {p, p, p};
}

double distance_to(const std::vector<Triangle>& surface, const Eigen::Vector3d& p) {
  const std::array<Triangle, 1> point = {point_triangle(p)};
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

/// The double that all of them together have no larger coordinate than.
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

double most_along(const std::vector<Triangle>& triangles, const Eigen::Vector3d& n) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Triangle& t : triangles)
    most = std::max({most, n.dot(t.a), n.dot(t.b), n.dot(t.c)});
  return most;
}

/// How far a plane across the normal must move B, the one way or the other: which of the two an
/// engine means by its normal is not judged.
double most_depth(const MeshReferee& referee, const Eigen::Vector3d& n) {
  const double forth = most_along(referee.triangles_a(), n) + most_along(referee.triangles_b(), -n);
  const double back = most_along(referee.triangles_a(), -n) + most_along(referee.triangles_b(), n);
  return std::max({forth, back, 0.0});
}

}  // namespace

std::optional<WitnessFault> fault_of_distance(const MeshReferee& referee,
                                              const CaseAnswer& answer) {
  if (!answer.point_a || !answer.point_b) return std::nullopt;
  const Eigen::Vector3d& a = *answer.point_a;
  const Eigen::Vector3d& b = *answer.point_b;
  const double largest = largest_coordinate(referee);
  const double bound =
      kTouchUlps * (std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest);
  const double off_a = distance_to(referee.triangles_a(), a);
  const double off_b = distance_to(referee.triangles_b(), b);
  const double off_gap = root_error(
      *answer.distance, squared_distance(exactly(point_triangle(a)), exactly(point_triangle(b))));
  if (off_a > bound) return WitnessFault{"point_a is off the surface of A", off_a};
  if (off_b > bound) return WitnessFault{"point_b is off the surface of B", off_b};
  if (off_gap > bound) return WitnessFault{"the points are not so far apart", off_gap};
  return std::nullopt;
}

std::optional<WitnessFault> fault_of_contacts(const MeshReferee& referee,
                                              const CaseAnswer& answer) {
  const double bound = kFloatTolerance * largest_coordinate(referee);
  for (const CaseContact& contact : *answer.contacts) {
    const double off_unit = std::abs(contact.normal.norm() - 1);
    if (!(off_unit <= kFloatTolerance)) return WitnessFault{"a normal of another length", off_unit};
    const double beyond = contact.depth - most_depth(referee, contact.normal);
    if (beyond > bound) return WitnessFault{"a depth beyond both meshes", beyond};
    if (contact.point_a == contact.point_b) continue;  // the engine names one point only
    const double width = (contact.point_a - contact.point_b).dot(contact.normal);
    if (contact.depth - std::abs(width) > bound) {
      return WitnessFault{"points less far apart along the normal than it is deep",
                          contact.depth - std::abs(width)};
    }
  }
  return std::nullopt;
}

}  // namespace graze::compare
