#pragma once

#include <optional>
#include <string>

#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/judge/meshes/witness_check.h>

namespace graze::compare {

/// Holds what was found about the parts of an answer: one that cannot be, or, in words, what was
/// not judged; neither if all are right.
struct PartsReview {
  std::optional<WitnessFault> fault = {};
  std::string unjudged = {};
  ErrorClass error_class = ErrorClass::Real;  ///< the class of the fault
};

/// Puts the review into the judgement on the answer as a whole, which is right or not judged so
/// far.
inline void add_review(Judgement& judgement, const PartsReview& review, double ulp) {
  if (review.fault) {
    judgement.verdict = Verdict::Wrong;
    judgement.error_class = review.error_class;
    judgement.truth += ", but " + review.fault->what;
    judgement.error = review.fault->error;
    judgement.ulps = review.fault->error / ulp;
  } else if (!review.unjudged.empty()) {
    judgement.verdict = Verdict::NotJudged;
    judgement.truth += "; not judged: " + review.unjudged;
  }
}

}  // namespace graze::compare
