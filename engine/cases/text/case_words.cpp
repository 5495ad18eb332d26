#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/cases/case.h>
#include <graze/engine/cases/text/case_words.h>

#include <algorithm>
#include <array>

namespace graze {
namespace {

bool is_same(const std::optional<Eigen::Vector3d>& a, const std::optional<Eigen::Vector3d>& b) {
  return a.has_value() == b.has_value() && (!a || *a == *b);
}

bool is_same(const CaseContact& a, const CaseContact& b) {
  return a.point == b.point && a.point_a == b.point_a && a.point_b == b.point_b &&
         a.normal == b.normal && a.depth == b.depth;
}

/// False only if both have a point and these differ.
bool can_be_same(const std::optional<Eigen::Vector3d>& a, const std::optional<Eigen::Vector3d>& b) {
  return !a || !b || *a == *b;
}

bool is_same(const CaseShapeContact& a, const CaseShapeContact& b) {
  return a.point == b.point && can_be_same(a.point_a, b.point_a) &&
         can_be_same(a.point_b, b.point_b) && a.normal == b.normal && a.depth == b.depth &&
         a.feature == b.feature;
}

bool is_same(const RayHit& a, const RayHit& b) {
  return a.distance == b.distance && a.point == b.point && a.normal == b.normal &&
         a.triangle == b.triangle;
}

bool is_same(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a == b;
}

template <typename Item>
bool is_same(const std::optional<std::vector<Item>>& a, const std::optional<std::vector<Item>>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return std::equal(a->begin(), a->end(), b->begin(), b->end(),
                    [](const Item& s, const Item& t) { return is_same(s, t); });
}

bool is_same(const std::optional<CaseIntersection>& a, const std::optional<CaseIntersection>& b) {
  return a.has_value() == b.has_value() && (!a || is_same(*a, *b));
}

}  // namespace

bool is_same(const CaseAnswer& a, const CaseAnswer& b) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    return a.says == b.says && a.pairs == b.pairs && a.triangles == b.triangles &&
           a.distance == b.distance && a.lower_bound == b.lower_bound &&
           a.is_converged == b.is_converged && is_same(a.normal, b.normal) &&
           is_same(a.point_a, b.point_a) && is_same(a.point_b, b.point_b) && a.pair == b.pair &&
           is_same(a.translation, b.translation) && is_same(a.contacts, b.contacts) &&
           is_same(a.manifold, b.manifold) && is_same(a.intersection, b.intersection) &&
           is_same(a.corners, b.corners) && is_same(a.hits, b.hits) && a.status == b.status &&
           a.low == b.low && a.high == b.high;
  });
}

const char* name_of(Ask ask) {
  for (const auto& [name, value] : cases::kAsks) {
    if (value == ask) return name;
  }
  return "?";
}

const char* name_of(RigidStatus status) {
  for (const auto& [name, value] : cases::kStatuses) {
    if (value == status) return name;
  }
  return "?";
}

const char* name_of(const CaseShape& shape) {
  constexpr std::array kNames = {"triangle", "box",  "obb",  "sphere",
                                 "point",    "mesh", "body", "ray"};
  static_assert(kNames.size() == std::variant_size_v<CaseShape>);
  return kNames[shape.index()];
}

}  // namespace graze
