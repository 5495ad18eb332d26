#include <graze/engine/compare/judge/bodies/body_judges.h>
#include <graze/engine/compare/judge/bodies/body_parting.h>
#include <graze/engine/compare/judge/rational/in_metres.h>

#include <cmath>

namespace graze::compare {
namespace {

/// graze's translation is its depth times a normal, each product rounded; others' normals are unit
/// to single precision.
constexpr double kOurLength = 0x1p-46;

bool is_surface(const PlacedBody& body) {
  return body.shape.kind() == ShapeKind::Mesh || body.shape.kind() == ShapeKind::Plane;
}

PartsReview fault(const char* what, double error) {
  return {.fault = WitnessFault{what, error}};
}

/// Of two that meet, or may.
PartsReview review_length(const PlacedBody& a, const PlacedBody& b, const Eigen::Vector3d& by,
                          double tolerance) {
  const double length = by.norm();
  const PlacedBody there{b.shape, b.pose};
  if (length <= tolerance) {
    const double still = shared_depth(a, there);
    return still > tolerance ? fault("still a hit after it", still) : PartsReview{};
  }
  const Eigen::Vector3d n = by / length;
  const double needed = needed_along(a, b, n);
  if (length > std::max(needed, 0.0) + tolerance)
    return fault("longer than it must be along its own way", length - needed);
  if (needed <= length + tolerance) return {};
  Pose moved = b.pose;
  moved.translation() += by;
  const double still = shared_depth(a, {b.shape, moved});
  if (still > tolerance) return fault("still a hit after it", still);
  return {.unjudged = "that they are apart after it" +
                      in_metres(": a plane across it parts them after", needed)};
}

}  // namespace

Judgement judge_separation(const PlacedBody& a, const PlacedBody& b, std::optional<bool> is_hit,
                           const CaseAnswer& answer, bool is_graze) {
  Judgement judgement;
  if (is_surface(a) || is_surface(b) || !is_hit) return judgement;
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
    review = review_length(a, b, *answer.translation, tolerance);
    if (!review.fault) judgement.truth += ", apart after it";
  }
  add_review(judgement, review, 1);
  return judgement;
}

}  // namespace graze::compare
