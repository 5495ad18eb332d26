#include <graze/engine/compare/judge/bodies/body_judges.h>
#include <graze/engine/compare/judge/bodies/body_parting.h>
#include <graze/engine/compare/judge/bodies/distance_bounds.h>
#include <graze/engine/compare/judge/bodies/least_parting.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/compare/judge/rational/in_metres.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

/// Normals are unit to some ulp. A search that did not end must be right to kShapeTolerance.
constexpr double kUnitTolerance = 0x1p-48;

bool is(const PlacedBody& body, ShapeKind kind) {
  return body.shape.kind() == kind;
}

/// Returns by how much a plane across the unit direction has A behind it and B before it.
double gap_along(const PlacedBody& a, const PlacedBody& b, const Vector3d& n) {
  const double gap = -support_along(b.shape, b.pose, -n) - support_along(a.shape, a.pose, n);
  return std::isnan(gap) ? -std::numeric_limits<double>::infinity() : gap;
}

/// Reviews a number alone, without points and a normal that would show it.
PartsReview review_number(const PlacedBody& a, const PlacedBody& b, double claimed,
                          double tolerance) {
  const DistanceBounds proved = distance_bounds(a, b);
  const auto beside = [&](const char* what) { return std::string(what) + ": " + proved.text(); };
  if (claimed < proved.least - tolerance)
    return {.fault =
                WitnessFault{beside("nearer than a plane lets them be"), proved.least - claimed}};
  if (claimed > proved.most + tolerance)
    return {.fault = WitnessFault{beside("two points are nearer"), claimed - proved.most}};
  if (proved.least >= claimed - tolerance && proved.most <= claimed + tolerance) return {};
  return {.unjudged = beside("that nothing is nearer")};
}

/// Reviews a number below zero. It claims a touch and, by engines that say more, how deep it is.
/// What they mean by that is theirs to say, so that another depth than the least is not judged
/// wrong.
PartsReview review_below_zero(const PlacedBody& a, const PlacedBody& b, double depth) {
  if (depth == 1) return {};  // no number at all
  if (is_surface(a) || is_surface(b)) return {.unjudged = "how deep"};
  const double tolerance = parting_tolerance(a, b, false);
  const std::optional<LeastParting> shortest =
      least_parting(a, b, Eigen::Vector3d::UnitX(), tolerance / 4);
  if (!shortest) return {.unjudged = "how deep"};
  if (depth <= shortest->least + tolerance && depth >= shortest->most - tolerance) return {};
  return {.unjudged = "how deep" + in_metres(": a plane parts them after", shortest->most) +
                      in_metres(", and none before", std::max(shortest->least, 0.0))};
}

}  // namespace

PartsReview review_distance(const PlacedBody& a, const PlacedBody& b, const CaseAnswer& answer,
                            bool is_graze) {
  const auto fault = [](const char* what, double error) {
    return PartsReview{.fault = WitnessFault{what, error}};
  };
  const double claimed = *answer.distance;
  if (claimed < 0 && is_graze) return fault("a distance below zero", -claimed);
  if (claimed < 0) return review_below_zero(a, b, -claimed);
  const double largest = std::max(largest_of(a), largest_of(b));
  const double slack = kTouchUlps * 0x1p-52 * largest;
  const bool has_ended = answer.is_converged.value_or(true);
  const double tolerance =
      has_ended ? distance_tolerance(a, b) : kShapeTolerance * 4 * largest + slack;
  const bool is_apart = claimed > 0;
  if (const std::optional<double> exact = exact_distance(a, b)) {
    if (std::abs(*exact - claimed) > slack)
      return fault("another distance", std::abs(*exact - claimed));
  }
  if (answer.point_a && answer.point_b) {
    const double between = (*answer.point_a - *answer.point_b).norm();
    if (std::abs(between - claimed) > tolerance)
      return fault("points that are not so far apart", std::abs(between - claimed));
    // For intersecting shapes it is a point in both; for a mesh, which is a surface, it is near
    // what is met.
    const bool has_mesh = is(a, ShapeKind::Mesh) || is(b, ShapeKind::Mesh);
    for (const PlacedBody* body : {&a, &b}) {
      const double off =
          outside_by(body->shape, body->pose, body == &a ? *answer.point_a : *answer.point_b);
      if (off > tolerance && (is_apart || !has_mesh))
        return fault(body == &a ? "point_a is off A" : "point_b is off B", off);
      if (is_apart && off < -tolerance)
        return fault(body == &a ? "point_a is inside A" : "point_b is inside B", -off);
    }
  }
  if (answer.normal) {
    const double off_unit = std::abs(answer.normal->norm() - 1);
    if (!(off_unit <= kUnitTolerance)) return fault("a normal of another length", off_unit);
  }
  if (answer.lower_bound && *answer.lower_bound > claimed + slack)
    return fault("a lower bound above the distance", *answer.lower_bound - claimed);
  if (!is_apart) {  // whether they meet was judged before
    return answer.normal ? PartsReview{.unjudged = "the normal of what meets"} : PartsReview{};
  }
  if (answer.normal && answer.point_a && answer.point_b) {
    // Whatever the shapes are, the normal leads from A to B.
    const double along = answer.normal->dot(*answer.point_b - *answer.point_a);
    if (along < -tolerance) return fault("a normal from B to A", -along);
  }
  double proved = -std::numeric_limits<double>::infinity();
  if (answer.normal) proved = gap_along(a, b, *answer.normal);
  const bool are_convex = !is(a, ShapeKind::Mesh) && !is(b, ShapeKind::Mesh);
  if (are_convex && answer.lower_bound && answer.normal &&
      *answer.lower_bound > std::max(proved, 0.0) + slack) {
    return fault("a lower bound that its normal does not prove", *answer.lower_bound - proved);
  }
  if (answer.point_a && answer.point_b && claimed > tolerance)
    proved = std::max(proved, gap_along(a, b, (*answer.point_b - *answer.point_a).normalized()));
  if (exact_distance(a, b) || proved >= claimed - tolerance) return {};
  if (are_convex && answer.is_converged.value_or(false))
    return fault("a distance that no plane proves", claimed - std::max(proved, 0.0));
  if (are_convex) return review_number(a, b, claimed, tolerance);
  return {.unjudged = "that nothing is nearer"};
}

}  // namespace graze::compare
