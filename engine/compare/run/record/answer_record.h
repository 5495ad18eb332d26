#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/run/record/baseline.h>

namespace graze::compare {

/// Among the names of engines this one stands for the answers of cases.
inline constexpr const char* kRecorded = "recorded";

/// Holds what one engine answered to one question.
struct AnswerRecord {
  std::string engine;
  std::string digest;      ///< answer_digest(); empty if it gave no answer
  std::string brief;       ///< the answer in a few characters
  double time = 0;         ///< microseconds, as recorded_time() has them
  bool is_agreed = false;  ///< true if no engine contradicted, so that the referee was not asked
  Judgement judgement;
  /// The number that is the answer: a distance in metres, or a first contact in shares of the
  /// motion; none where the answer is no such number.
  std::optional<double> value = {};

  bool is_wrong() const { return judgement.verdict == Verdict::Wrong; }
};

/// Holds what all engines answered in one pose of B, or to one case.
struct PlaceRecord {
  std::size_t place = 0;  ///< counted from 0
  std::vector<AnswerRecord> answers;
};

/// Returns 16 digits, equal for equal answers, bit for bit: the beginning of the SHA-256 of the
/// answer's JSON.
std::string answer_digest(const CaseAnswer& answer);

/// Returns AnswerRecord::value of an answer.
std::optional<double> answer_value(const CaseAnswer& answer);

/// Return one answer and its judgement as a JSON object, or a list of them; numbers are plain ones
/// of as many digits as read back as the same double.
std::string to_json(const AnswerRecord& answer);
std::string to_json(std::span<const AnswerRecord> answers);

/// Read the same from JSON. Throw CaseError.
AnswerRecord read_answer(const cases::JsonCursor& at);
std::vector<AnswerRecord> read_answers(const cases::JsonCursor& at);

/// Returns one line of JSON, without its line break; `name` is what a place is called: "pose",
/// "case".
std::string to_json(const PlaceRecord& record, std::string_view name);

/// Says which places may stand in a line: all places come in their order, so that it is `next`.
struct ExpectedPlace {
  std::size_t next = 0;
  std::size_t end = 0;  ///< the place behind the last that there is
};
PlaceRecord read_place_record(const cases::JsonCursor& at, std::string_view name,
                              const ExpectedPlace& expected);

/// Reads a number below `end`.
std::size_t read_place(const cases::JsonCursor& at, std::size_t end);
/// Reads the number of the next place.
std::size_t read_place(const cases::JsonCursor& at, const ExpectedPlace& expected);

/// Returns what is held against another run.
std::vector<SaidThere> said_there(const PlaceRecord& record);

}  // namespace graze::compare
