#pragma once

#include <optional>
#include <string>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/cli/reasons/reasons.h>
#include <graze/engine/compare/judge/classics/blame.h>
#include <graze/engine/compare/judge/judgement.h>

namespace graze::cli {

/// Says why somebody's answer to a case is wrong, as far as textbook tests of two triangles show
/// it, or what proves the truth.
struct CaseExplanation {
  std::string question;
  std::string engine;  ///< the engine with its version
  std::string says;
  compare::Judgement judgement;
  std::optional<TrianglePair> pair = {};  ///< the pair that shows it best; none if no two triangles
                                          ///< do
  std::vector<compare::ClassicVariant> variants = {};
  /// Holds what proves the truth about shapes, motions, rays and points, whatever the verdict; none
  /// for other cases.
  std::optional<Reasons> reasons = {};
  std::string why;  ///< the reason in words
};

/// Explains a case, which must have an answer.
CaseExplanation explain_case(const Case& query);

std::string to_text(const CaseExplanation& explanation);
std::string to_json(const CaseExplanation& explanation);

}  // namespace graze::cli
