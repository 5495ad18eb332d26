#include <graze/bvh/obb.h>
#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/depth/box_axes.h>
#include <graze/narrowphase/convex/gap/ball_gap.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>
#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/volumes/obb_rows.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Returns distances of pairs whose test is more exact than the distance of their cores: if two are
// apart by less than the rounding of that distance, it is computed once more, in twice the
// precision or from all features.

namespace graze {

using narrowphase::Core;
using narrowphase::CoreGap;
using narrowphase::DoublePair;
using narrowphase::Vec3;

namespace {

constexpr double kLeast = std::numeric_limits<double>::denorm_min();

DoublePair square_of(const DoublePair& value) {
  return value * value;
}

/// Returns length - radius from the square of the length. The length is greater than the radius by
/// less than either is.
double beyond(const DoublePair& square, const DoublePair& radius) {
  const DoublePair difference = square - square_of(radius);
  return difference.high / (std::sqrt(square.high) + radius.high);
}

Vec3 in_axes(const Pose& pose, const Vec3& own) {
  const double* m = pose.data();
  return {(m[0] * own.x + m[4] * own.y) + m[8] * own.z,
          (m[1] * own.x + m[5] * own.y) + m[9] * own.z,
          (m[2] * own.x + m[6] * own.y) + m[10] * own.z};
}

}  // namespace

ShapeDistance agreeing(ShapeDistance found, bool is_hit) {
  if (is_hit) {
    found.distance = 0;
    found.lower_bound = 0;
  } else if (!(found.distance > 0)) {
    found.distance = kLeast;
  }
  return found;
}

// The square is off by 2^-98 of itself, and so is that of the radii: their difference over the sum
// of both ways by less than 2^-96 of the greater. The quotient rounds three times.
ShapeDistance distance_of_spheres(const PlacedShapeView& a, const PlacedShapeView& b, bool is_hit,
                                  Work& work) {
  ShapeDistance found = distance_of_cores(a, b, work);
  if (is_hit || found.distance > 0) return agreeing(found, is_hit);
  const Sphere& sphere_a = *a.shape.as<Sphere>();
  const Sphere& sphere_b = *b.shape.as<Sphere>();
  const Vec3 from = to_vec3(middle_of(a.shape, a.pose)), to = to_vec3(middle_of(b.shape, b.pose));
  const DoublePair x = narrowphase::exact_difference(to.x, from.x);
  const DoublePair y = narrowphase::exact_difference(to.y, from.y);
  const DoublePair z = narrowphase::exact_difference(to.z, from.z);
  const DoublePair radii = narrowphase::exact_difference(sphere_a.radius, -sphere_b.radius);
  const double gap = beyond((square_of(x) + square_of(y)) + square_of(z), radii);
  const Vec3 normal = unit_or(Vec3{x.high, y.high, z.high}, {0, 0, 1});
  found.distance = std::max(gap, kLeast);
  found.lower_bound = std::max(gap * (1 - 0x1p-50) - 0x1p-96 * radii.high, 0.0);
  found.point_a = to_eigen(from + normal * sphere_a.radius);
  found.point_b = to_eigen(to - normal * sphere_b.radius);
  found.normal = to_eigen(normal);
  return found;
}

// The exact test reads the centre in the box's frame, rounded once (law 3). The distance from there
// is not proved for the box as its pose places it, so the bound stays 0.
ShapeDistance distance_of_sphere_and_box(const PlacedShapeView& a, const PlacedShapeView& b,
                                         bool is_hit, Work& work) {
  ShapeDistance found = distance_of_cores(a, b, work);
  if (is_hit || found.distance > 0) return agreeing(found, is_hit);
  const double radius = a.shape.as<Sphere>()->radius;
  const Eigen::Vector3d centre = middle_of(a.shape, a.pose);
  const Vec3 own = to_vec3(narrowphase::point_into_frame(centre, b.pose));
  const Vec3 half = to_vec3(b.shape.as<Box>()->half_extents);
  DoublePair square{0, 0};
  const auto past = [&](double at, double half_extent) {
    const DoublePair excess = narrowphase::exact_difference(std::abs(at), half_extent);
    if (!(excess.high > 0)) return 0.0;
    square = square + square_of(excess);
    return at < 0 ? -excess.high : excess.high;
  };
  const Vec3 out{past(own.x, half.x), past(own.y, half.y), past(own.z, half.z)};
  const double gap = beyond(square, {radius, 0});
  const Vec3 toward_box = -unit_or(in_axes(b.pose, out), {0, 0, 1});
  const Vec3 on_sphere = to_vec3(centre) + toward_box * radius;
  found.distance = std::max(gap, kLeast);
  found.point_a = to_eigen(on_sphere);
  found.point_b = to_eigen(on_sphere + toward_box * found.distance);
  found.normal = to_eigen(toward_box);
  return found;
}

// Where the bounds leave open whether the two touch, the exact test decides.
SetGap gap_of_ball(const Sphere& placed, const Triangle& triangle) {
  const narrowphase::BallGap gap = narrowphase::ball_gap(placed, triangle);
  SetGap result{};
  result.is_apart = gap.lower > 0 || !narrowphase::decide(triangle, placed).is_hit;
  result.distance = result.is_apart ? std::max(gap.upper, kLeast) : 0;
  result.lower = result.is_apart ? std::max(gap.lower, 0.0) : 0;
  result.normal = gap.normal;
  result.point_b = gap.to_point;
  result.point_a =
      result.is_apart ? unit_or(gap.to_point, gap.normal) * placed.radius : gap.to_point;
  double scale = 0;  // a scale that is no more than the pair's
  for (const Eigen::Vector3d* corner : {&triangle.a, &triangle.b, &triangle.c})
    scale = std::max(scale, placed.radius + length(to_vec3(*corner) - to_vec3(placed.centre)));
  const bool is_known = result.distance - result.lower <= kTouchTolerance * scale;
  result.status = is_known ? PairStatus::Converged : PairStatus::NotConverged;
  return result;
}

namespace {

// Shares of the sizes of two boxes, for rounding and for deviations. They are more than the slack
// of the axes (volumes/boxes/obb_slack.h): 0xa0p-53 and 12 of the sums of half extents, which are
// at most 1.74 times the sizes.
constexpr double kRoundingOfAxes = 0x200p-53;
constexpr double kDeviationOfAxes = 32;

/// True if edges of the two are at an angle of less than that sine.
bool have_parallel_edges(const Pose& pose_a, const Pose& pose_b, double sine) {
  const double* m = pose_a.data();  // column-major 4x4
  const double* o = pose_b.data();
  for (int i = 0; i < 12; i += 4) {
    for (int j = 0; j < 12; j += 4) {
      const double cosine = (m[i] * o[j] + m[i + 1] * o[j + 1]) + m[i + 2] * o[j + 2];
      if (1 - cosine * cosine < sine * sine + 4 * kMaxRotationDeviation) return true;
    }
  }
  return false;
}

}  // namespace

// An axis of length sin(phi) that parts two boxes by a gap shows that unless gap sin(phi) is within
// the slack: a gap above the tolerance is hidden only for angles below slack / tolerance.
bool intersect_boxes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const narrowphase::ObbRow row_a = narrowphase::row_of(placed_box(a));
  const narrowphase::ObbRow row_b = narrowphase::row_of(placed_box(b));
  if (!narrowphase::may_overlap(row_a, row_b)) return false;
  const double deviation = row_a[narrowphase::kDeviationRow] + row_b[narrowphase::kDeviationRow];
  const double sine = (kRoundingOfAxes + kDeviationOfAxes * deviation) / kTouchTolerance;
  if (!have_parallel_edges(a.pose, b.pose, sine)) return true;
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const Core core_a = core_of(a.shape, a.pose, origin), core_b = core_of(b.shape, b.pose, origin);
  if (!narrowphase::BoxAxes(core_a, core_b).may_hide_gap(sine)) return true;
  PairStatus status{};
  const bool is_apart = are_apart(core_a, core_b, status);
  ++work.convex_tests;
  work.convex_failures += status == PairStatus::NotConverged;
  return !is_apart;
}

ShapeDistance distance_of_boxes(const PlacedShapeView& a, const PlacedShapeView& b, bool is_hit,
                                Work& work) {
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const Core core_a = core_of(a.shape, a.pose, origin), core_b = core_of(b.shape, b.pose, origin);
  SetGap gap = gap_of_sets(core_a, core_b);
  ++work.convex_tests;
  if (!is_hit && (!gap.is_apart || gap.status == PairStatus::NotConverged)) {
    const CoreGap all = narrowphase::box_gap(core_a, core_b);
    gap = set_gap(core_a, core_b, all);
    if (!gap.is_apart) {
      gap.distance = std::max(all.upper, kLeast);
      gap.point_a = all.point_a;
      gap.point_b = all.point_b;
    }
  }
  work.convex_failures += gap.status == PairStatus::NotConverged;
  const ShapeDistance found{gap.distance,
                            gap.lower,
                            to_eigen(gap.point_a + to_vec3(origin)),
                            to_eigen(gap.point_b + to_vec3(origin)),
                            to_eigen(gap.normal),
                            gap.status};
  return agreeing(found, is_hit);
}

}  // namespace graze
