#include <graze/engine/compare/judge/bodies/body_judges.h>
#include <graze/engine/compare/judge/bodies/distance_bounds.h>

#include <algorithm>

namespace graze::compare {

Judgement judge_within(const PlacedBody& a, const PlacedBody& b, std::optional<bool> is_hit,
                       const Case& query, bool says, bool is_graze) {
  const double clearance = query.settings.clearance;
  const DistanceBounds bounds = is_hit.value_or(false) ? DistanceBounds() : distance_bounds(a, b);
  const double rounding = kTouchUlps * 0x1p-52 * std::max(largest_of(a), largest_of(b));
  const double searched = bounds.is_exact ? rounding : distance_tolerance(a, b);
  Judgement judgement;
  judgement.truth = is_hit.value_or(false) ? "they meet" : bounds.text();
  const bool is_near = is_hit.value_or(false) || bounds.most + searched <= clearance;
  const bool is_far = bounds.least - rounding > clearance;
  if (!is_near && !is_far) {
    judgement.truth += "; not judged: which of these the clearance is";
    return judgement;
  }
  const double off = is_far ? bounds.least - clearance : clearance - bounds.most;
  const bool is_promised = is_graze && says && off <= searched;
  judgement.verdict = says == is_near || is_promised ? Verdict::Right : Verdict::Wrong;
  if (judgement.verdict == Verdict::Wrong) judgement.error = off;
  return judgement;
}

}  // namespace graze::compare
