#include <graze/bvh/error.h>
#include <graze/engine/compare/judge/bodies/body_judges.h>
#include <graze/engine/compare/judge/bodies/body_parting.h>
#include <graze/engine/compare/judge/bodies/least_parting.h>
#include <graze/engine/compare/judge/rational/in_metres.h>

#include <algorithm>
#include <cmath>

namespace graze::compare {
namespace {

/// graze's translation is its depth times a normal, each product rounded; others' normals are unit
/// to single precision.
constexpr double kOurLength = 0x1p-46;

/// Where both are boxes the engines grant themselves a twentieth: a face is taken where two edges
/// would be nearer by less, so that contacts do not change with each step.
constexpr double kBoxGrant = 0.05;

/// The bounds of a shortest translation are looked for to this share of what is granted.
constexpr double kShareOfTolerance = 0.25;

bool is_box(const PlacedBody& body) {
  return body.shape.kind() == ShapeKind::Box;
}

PartsReview fault(const char* what, double error) {
  return {.fault = WitnessFault{what, error}};
}

/// Reviews the length for two that meet, or may.
PartsReview review_length(const PlacedBody& a, const PlacedBody& b, const Eigen::Vector3d& by,
                          double tolerance) {
  const double length = by.norm();
  if (length > tolerance) {
    const double needed = needed_along(a, b, by / length);
    if (length > std::max(needed, 0.0) + tolerance)
      return fault("longer than it must be along its own direction", length - needed);
    if (needed <= length + tolerance) return {};
  }
  return review_parted(a, b, {by, length, tolerance});
}

/// Reviews surfaces: one that is led out of another is apart by the referee, or by a proof.
PartsReview review_surfaces(const PlacedBody& a, const PlacedBody& b, const Eigen::Vector3d& by,
                            double tolerance) {
  const double length = by.norm();
  Pose moved = b.pose;
  moved.translation() += length > 0 ? Eigen::Vector3d((1 + tolerance / length) * by) : by;
  try {
    const Judgement apart = ShapeJudge(a, {b.shape, moved}).judge(false, {"referee", ""});
    if (apart.verdict == Verdict::Right) return {};
    if (apart.verdict == Verdict::Wrong && apart.error > tolerance)
      return fault("still a hit after it", apart.error);
  } catch (const Error&) {  // B is taken out of the range of double
  }
  return {.unjudged = "that they are apart after it"};
}

/// Returns whether the two hit, if it is known; the shapes' judge leaves two meshes to the meshes'
/// judge.
std::optional<bool> known_hit(const PlacedBody& a, const PlacedBody& b) {
  const bool are_meshes = a.shape.kind() == ShapeKind::Mesh && b.shape.kind() == ShapeKind::Mesh;
  if (!are_meshes) return std::nullopt;
  return ShapeJudge(a, b).judge(true, {"referee", ""}).verdict == Verdict::Right;
}

}  // namespace

bool is_surface(const PlacedBody& body) {
  return body.shape.kind() == ShapeKind::Mesh || body.shape.kind() == ShapeKind::HeightField;
}

PartsReview review_parted(const PlacedBody& a, const PlacedBody& b, const WayOut& way_out) {
  Pose moved = b.pose;
  if (way_out.length > 0) moved.translation() += way_out.length * way_out.direction.normalized();
  const std::optional<LeastParting> left =
      least_parting(a, {b.shape, moved}, way_out.direction, kShareOfTolerance * way_out.tolerance);
  if (!left) return {.unjudged = "that they are apart after it"};
  if (left->least > way_out.tolerance) {
    return {.fault = WitnessFault{"still a hit after it" +
                                      in_metres(": a plane parts them after another", left->most) +
                                      in_metres(", and none before", left->least),
                                  left->least}};
  }
  if (left->most <= way_out.tolerance) return {};
  return {.unjudged = "that they are apart after it" +
                      in_metres(": a plane parts them after another", left->most)};
}

PartsReview review_least(const PlacedBody& a, const PlacedBody& b, const WayOut& way_out,
                         std::string& truth) {
  const std::optional<LeastParting> shortest =
      least_parting(a, b, way_out.direction, kShareOfTolerance * way_out.tolerance);
  if (!shortest) return {.unjudged = "whether a shorter one does"};
  const bool are_bodies = !is_surface(a) && !is_surface(b);
  const double granted =
      way_out.tolerance + (is_box(a) && is_box(b) ? kBoxGrant * way_out.length : 0);
  const double most = std::max(shortest->most, 0.0);
  const double least = are_bodies ? std::max(shortest->least, 0.0) : 0;
  std::string bounds = in_metres("a plane parts them after", most);
  if (are_bodies) bounds += in_metres(", and none before", least);
  if (way_out.length > most + granted) {
    return {.fault = WitnessFault{in_metres("a way out of", way_out.length) +
                                      ", not the least: " + bounds,
                                  way_out.length - most},
            .error_class = ErrorClass::NotLeast};
  }
  truth += "; " + bounds;
  if (way_out.length <= least + granted) return {};
  return {.unjudged = "whether a shorter one does"};
}

Judgement judge_separation(const PlacedBody& a, const PlacedBody& b, std::optional<bool> is_hit,
                           const CaseAnswer& answer, bool is_graze) {
  Judgement judgement;
  if (!is_hit) is_hit = known_hit(a, b);
  if (!is_hit) return judgement;
  const double length = *answer.distance;
  const double tolerance = parting_tolerance(a, b, is_graze);
  judgement.truth = *is_hit ? "hit" : "apart";
  judgement.verdict = Verdict::Right;
  const double off = std::abs(answer.translation->norm() - length);
  PartsReview review;
  if (!(length >= 0)) {
    review = fault("a length below zero", -length);
  } else if (off > (is_graze ? kOurLength * length : tolerance)) {
    review = fault("a translation of another length", off);
  } else if (!*is_hit && length > tolerance) {
    review = fault("there is nothing to undo", length);
  } else if (*is_hit) {
    const bool are_bodies = !is_surface(a) && !is_surface(b);
    review = are_bodies ? review_length(a, b, *answer.translation, tolerance)
                        : review_surfaces(a, b, *answer.translation, tolerance);
    if (!review.fault && review.unjudged.empty()) {
      judgement.truth += ", apart after it";
      review = review_least(a, b, {*answer.translation, length, tolerance}, judgement.truth);
    }
  }
  add_review(judgement, review, 1);
  return judgement;
}

}  // namespace graze::compare
