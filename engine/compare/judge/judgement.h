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
  NotConfirmed,  ///< wrong once: asked again alone, the engine said something else
};

/// Why an answer is wrong, as far as exact arithmetic can tell; the later ones are worse. Which of
/// several that fit is said: class_of_pair() has the order, the same for every question.
enum class ErrorClass {
  Touching,      ///< the shapes touch, or miss each other, by no more than kTouchUlps
  PoseRounding,  ///< as small, and right if no pose had to be rounded
  Coplanar,      ///< as small, and one plane holds both triangles that show it best, exactly
  Degenerate,    ///< one of the two that show it best has exactly no area
  NotLeast,      ///< a way out of each other that parts the two, but a shorter one does
  Containment,   ///< more than kTouchUlps apart, and one closed mesh lies inside the other
  Real,          ///< none of these: a plain error
  EngineError,   ///< no answer to what was asked: triangles that are not there, no numbers, a throw
};

inline constexpr std::array kErrorClasses = {
    ErrorClass::Touching, ErrorClass::PoseRounding, ErrorClass::Coplanar, ErrorClass::Degenerate,
    ErrorClass::NotLeast, ErrorClass::Containment,  ErrorClass::Real,     ErrorClass::EngineError};

/// Beyond this many ulp of the largest coordinate an error is no longer one of rounding: some
/// twenty operations a coordinate, each off by half an ulp, and the square roots of their sums.
inline constexpr double kTouchUlps = 64;

/// What the referee says of one answer. Right only if every part of it has been judged: what is not
/// wrong, as far as it could be judged, is NotJudged, and the truth names what was not.
struct Judgement {
  Verdict verdict = Verdict::NotJudged;
  std::string truth;  ///< in words: "hit", "apart by 3.2e-17 m", "12 pairs"
  // Of a wrong answer:
  ErrorClass error_class = ErrorClass::Real;
  double error = 0;  ///< metres: the gap or depth that was overlooked, the error of a distance
  double ulps = 0;   ///< the same, in ulp of the largest placed coordinate of the culprits
  std::size_t wrong_pairs = 0;          ///< of a list
  std::optional<TrianglePair> culprit;  ///< the triangles that show it best
};

const char* name_of(Verdict verdict);
const char* name_of(ErrorClass error_class);

/// Why what an engine returned is no answer to the question, in words: "names triangle 99 of 12", a
/// list that does not ascend, a number that is none, an answer to another question. Nothing if it
/// is one, right or wrong.
std::optional<std::string> fault_of_answer(const Case& query, const CaseAnswer& answer);

/// The judgement on what is no answer: wrong, whatever is true.
Judgement engine_error(const std::string& why);

}  // namespace graze::compare
