#pragma once

#include <graze/engine/cases/case.h>

#include <array>
#include <functional>
#include <optional>
#include <string>

namespace graze::compare {

enum class Verdict {
  Right,
  Wrong,
  NotJudged,
  NotConfirmed,  ///< wrong once, but the engine said something else when it was asked again alone
};

/// Says why an answer is wrong, as far as exact arithmetic can tell; the later classes are worse.
/// If several fit, class_of_pair() has the order in which they are taken, the same for every
/// question.
enum class ErrorClass {
  Touching,      ///< the shapes touch, or miss each other, by no more than kTouchUlps
  PoseRounding,  ///< an error as small, in an answer that is right if no pose had to be rounded
  Coplanar,  ///< an error as small, where one plane holds both triangles that show it best, exactly
  Degenerate,   ///< one of the two that show it best has exactly no area
  NotLeast,     ///< a way out of each other that parts the two, but a shorter one does
  Containment,  ///< more than kTouchUlps apart, and one closed mesh lies inside the other
  Real,         ///< none of these: a plain error
  EngineError,  ///< no answer to what was asked: triangles that are not there, no numbers, a throw
};

inline constexpr std::array kErrorClasses = {
    ErrorClass::Touching, ErrorClass::PoseRounding, ErrorClass::Coplanar, ErrorClass::Degenerate,
    ErrorClass::NotLeast, ErrorClass::Containment,  ErrorClass::Real,     ErrorClass::EngineError};

/// Beyond this many ulp of the largest coordinate an error is no longer one of rounding: some
/// twenty operations a coordinate, each off by half an ulp, and the square roots of their sums.
inline constexpr double kTouchUlps = 64;

/// Holds what the referee says of one answer. It is Right only if every part of the answer has been
/// judged. If no part is wrong and some were not judged it is NotJudged, and the truth names these.
struct Judgement {
  Verdict verdict = Verdict::NotJudged;
  std::string truth;  ///< in words: "hit", "apart by 3.2e-17 m", "12 pairs"
  // The members from here to `culprit` are about a wrong answer.
  ErrorClass error_class = ErrorClass::Real;
  double error = 0;  ///< metres: the gap or depth that was overlooked, the error of a distance
  double ulps = 0;   ///< the same in ulp of the largest placed coordinate of the culprits
  std::size_t wrong_pairs = 0;          ///< wrong pairs of a list
  std::optional<TrianglePair> culprit;  ///< the triangles that show it best
};

const char* name_of(Verdict verdict);
const char* name_of(ErrorClass error_class);

/// Says why what an engine returned is no answer to the question, in words: "names triangle 99 of
/// 12", a list that does not ascend, a NaN, an answer to another question. Returns nothing if it is
/// an answer, right or wrong.
std::optional<std::string> fault_of_answer(const Case& query, const CaseAnswer& answer);

/// Returns the judgement on what is no answer: wrong, whatever is true.
Judgement engine_error(const std::string& why);

}  // namespace graze::compare
