#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/run/baseline.h>

namespace graze::compare {

/// What one engine answered to one question.
struct AnswerRecord {
  std::string engine;
  std::string digest;      ///< SHA-256 of the answer as JSON: equal for equal answers, bit for bit
  std::string brief;       ///< the answer in a few characters
  double time = 0;         ///< microseconds
  bool is_agreed = false;  ///< no engine contradicted, so that the referee was not asked
  Judgement judgement;

  bool is_wrong() const { return judgement.verdict == Verdict::Wrong; }
};

/// What all of them answered in one pose of B, or to one case.
struct PlaceRecord {
  std::size_t place = 0;  ///< counted from 0
  std::vector<AnswerRecord> answers;
};

/// One answer and its judgement as a JSON object, or a list of them; numbers are plain ones of as
/// many digits as read back as the same double.
std::string to_json(const AnswerRecord& answer);
std::string to_json(std::span<const AnswerRecord> answers);

/// The same from JSON. Throw CaseError.
AnswerRecord read_answer(const cases::JsonCursor& at);
std::vector<AnswerRecord> read_answers(const cases::JsonCursor& at);

/// One line of JSON, without its line break; `name` is what a place is called: "pose", "case".
std::string to_json(const PlaceRecord& record, std::string_view name);
PlaceRecord read_place_record(const cases::JsonCursor& at, std::string_view name,
                              std::size_t places);

/// A number below `end`.
std::size_t read_place(const cases::JsonCursor& at, std::size_t end);

GrazePart graze_part(const PlaceRecord& record);

}  // namespace graze::compare
