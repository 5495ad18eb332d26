#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/core/hull.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze {

using narrowphase::Core;
using narrowphase::CoreGap;
using narrowphase::GapVerdict;
using narrowphase::Vec3;

namespace {

/// Returns -1, 0 or 1 by the first numbers that differ.
int order(const double* a, const double* b, int count) {
  for (int i = 0; i < count; ++i) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
    // Zeros of either sign are equal, but results computed from them differ in bits.
    const bool is_negative = std::signbit(a[i]);
    if (is_negative != std::signbit(b[i])) return is_negative ? -1 : 1;
  }
  return 0;
}

/// Returns the order of the numbers of two shapes of one kind; 0 only where swapping them changes
/// nothing.
struct NumbersOf {
  const Shape::Value& other;

  int operator()(const Sphere& s) const {
    const auto& o = std::get<Sphere>(other);
    const int by_centre = order(s.centre.data(), o.centre.data(), 3);
    return by_centre != 0 ? by_centre : order(&s.radius, &o.radius, 1);
  }
  int operator()(const Box& s) const {
    return order(s.half_extents.data(), std::get<Box>(other).half_extents.data(), 3);
  }
  int operator()(const Capsule& s) const {
    const auto& o = std::get<Capsule>(other);
    const double of_s[] = {s.radius, s.half_length}, of_o[] = {o.radius, o.half_length};
    return order(of_s, of_o, 2);
  }
  int operator()(const Cylinder& s) const { return round(s); }
  int operator()(const Cone& s) const { return round(s); }
  int operator()(const Ellipsoid& s) const {
    const auto& o = std::get<Ellipsoid>(other);
    const int by_centre = order(s.centre.data(), o.centre.data(), 3);
    return by_centre != 0 ? by_centre : order(s.semi_axes.data(), o.semi_axes.data(), 3);
  }
  int operator()(const ConvexHull& s) const {
    const narrowphase::Hull& h = data_of(s);
    const narrowphase::Hull& o = data_of(std::get<ConvexHull>(other));
    const int by_middle = order(&h.middle.x, &o.middle.x, 3);
    if (by_middle != 0) return by_middle;
    const std::size_t count = std::min(h.corners.size(), o.corners.size());
    for (std::size_t i = 0; i < count; ++i) {
      const int by_corner = order(&h.corners[i].x, &o.corners[i].x, 3);
      if (by_corner != 0) return by_corner;
    }
    return h.corners.size() < o.corners.size() ? -1 : h.corners.size() > o.corners.size();
  }
  int operator()(const HalfSpace& s) const {
    const auto& o = std::get<HalfSpace>(other);
    const int by_normal = order(s.normal.data(), o.normal.data(), 3);
    return by_normal != 0 ? by_normal : order(&s.offset, &o.offset, 1);
  }
  /// Half-spaces replace planes wherever the order matters.
  int operator()(const graze::Plane&) const { return 0; }
  int operator()(const Mesh& s) const {
    const Mesh& o = std::get<Mesh>(other);
    if (s == o) return 0;
    const auto by_vertex = std::lexicographical_compare_three_way(
        s.vertices().begin(), s.vertices().end(), o.vertices().begin(), o.vertices().end(),
        [](const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
          return order(v.data(), w.data(), 3) <=> 0;
        });
    const auto by_number = by_vertex != 0 ? by_vertex
                                          : std::lexicographical_compare_three_way(
                                                s.triangles().begin(), s.triangles().end(),
                                                o.triangles().begin(), o.triangles().end());
    return by_number < 0 ? -1 : by_number > 0;
  }
  /// Meshes replace height fields wherever the order matters.
  int operator()(const HeightField&) const { return 0; }

 private:
  template <typename Round>
  int round(const Round& s) const {
    const auto& o = std::get<Round>(other);
    const double of_s[] = {s.radius, s.half_height}, of_o[] = {o.radius, o.half_height};
    return order(of_s, of_o, 2);
  }
};

/// Returns the point at that distance from A's core towards B's.
Vec3 between(const CoreGap& gap, double distance) {
  if (!(gap.upper > 0)) return gap.point_a;
  return gap.point_a + (gap.point_b - gap.point_a) * (distance / gap.upper);
}

/// Returns some point of both sets. Their cores have points that are `upper` apart, which is at
/// most the sum of the radii.
Vec3 common_point(const Core& a, const Core& b, const CoreGap& gap) {
  const double from = std::max(0.0, gap.upper - b.radius);
  const double to = std::min(a.radius, gap.upper);
  return between(gap, 0.5 * from + 0.5 * to);
}

}  // namespace

bool is_swapped(const PlacedShapeView& a, const PlacedShapeView& b) {
  if (a.shape.kind() != b.shape.kind()) return b.shape.kind() < a.shape.kind();
  const double* of_a = a.pose.data();
  const double* of_b = b.pose.data();
  const int by_place = order(of_a + 12, of_b + 12, 3);
  if (by_place != 0) return by_place > 0;
  const int by_rotation = order(of_a, of_b, 12);
  if (by_rotation != 0) return by_rotation > 0;
  return std::visit(NumbersOf{b.shape.value()}, a.shape.value()) > 0;
}

ShapeDistance mirrored(ShapeDistance found) {
  std::swap(found.point_a, found.point_b);
  found.normal = to_eigen(-to_vec3(found.normal));
  return found;
}

void check_poses(const Pose& pose_a, const Pose& pose_b) {
  check_pose(pose_a, "pose of A");
  check_pose(pose_b, "pose of B");
}

SetGap gap_of_sets(const Core& a, const Core& b, double limit) {
  const double radii = a.radius + b.radius;
  const double slack = 0x1p-46 * pair_scale(a, b);  // not less than any gap.slack
  return set_gap(a, b, narrowphase::nearest(a, b, {.apart_beyond = limit + radii + slack}));
}

SetGap set_gap(const Core& a, const Core& b, const CoreGap& gap) {
  const double radii = a.radius + b.radius;
  SetGap result{};
  result.lower = std::max(gap.lower - radii - gap.slack, 0.0);
  result.is_apart = result.lower > 0;
  const bool is_open =
      gap.verdict == GapVerdict::NotReached && !result.is_apart && gap.upper > radii;
  result.status = is_open ? PairStatus::NotConverged : PairStatus::Converged;
  result.normal = gap.normal;
  if (result.is_apart) {
    result.normal = narrowphase::gap_normal(a, b, gap);
    result.distance = gap.upper - radii;
    result.point_a = between(gap, a.radius);
    result.point_b = between(gap, gap.upper - b.radius);
    if (gap.verdict == GapVerdict::NotReached) result.status = PairStatus::NotConverged;
  } else {
    result.point_a = common_point(a, b, gap);
    result.point_b = result.point_a;
  }
  return result;
}

bool are_apart(const Core& a, const Core& b, PairStatus& status) {
  const double radii = a.radius + b.radius;
  const double slack = 0x1p-46 * pair_scale(a, b);  // not less than any gap.slack
  const CoreGap gap =
      narrowphase::nearest(a, b, {.apart_beyond = radii + slack, .near_enough = radii});
  const bool is_apart = gap.lower - radii - gap.slack > 0;
  const bool is_open = gap.verdict == GapVerdict::NotReached && !is_apart && gap.upper > radii;
  status = is_open ? PairStatus::NotConverged : PairStatus::Converged;
  return is_apart;
}

}  // namespace graze
