#pragma once

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/peers/engine.h>

#include <optional>
#include <utility>

namespace graze::compare {

/// Returns what this library answers about two meshes or two shapes where they are placed; in a
/// question about motions each goes along its course.
template <typename Placed>
CaseAnswer graze_answer(const Question& question, Placed a, Placed b) {
  a.course = question.course_a;
  b.course = question.course_b;
  return answer_case({.note = "",
                      .ask = question.ask,
                      .settings = question.settings,
                      .a = std::move(a),
                      .b = std::move(b),
                      .answer = std::nullopt,
                      .answered_by = {}});
}

}  // namespace graze::compare
