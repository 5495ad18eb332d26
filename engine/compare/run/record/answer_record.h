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

/// The name that the answers of cases have among those of engines.
inline constexpr const char* kRecorded = "recorded";

/// What one engine answered to one question.
struct AnswerRecord {
  std::string engine;
  std::string digest;      ///< answer_digest(); empty: it gave none
  std::string brief;       ///< the answer in a few characters
  double time = 0;         ///< microseconds, as recorded_time() has them
  bool is_agreed = false;  ///< no engine contradicted, so that the referee was not asked
  Judgement judgement;
  /// The number that is the answer, of a distance in metres or of a first contact in shares of the
  /// motion; none where the answer is no such number.
  std::optional<double> value = {};

  bool is_wrong() const { return judgement.verdict == Verdict::Wrong; }
};

/// What all of them answered in one pose of B, or to one case.
struct PlaceRecord {
  std::size_t place = 0;  ///< counted from 0
  std::vector<AnswerRecord> answers;
};

/// 16 digits, equal for equal answers, bit for bit: the beginning of the SHA-256 of its JSON.
std::string answer_digest(const CaseAnswer& answer);

/// AnswerRecord::value of an answer.
std::optional<double> answer_value(const CaseAnswer& answer);

/// One answer and its judgement as a JSON object, or a list of them; numbers are plain ones of as
/// many digits as read back as the same double.
std::string to_json(const AnswerRecord& answer);
std::string to_json(std::span<const AnswerRecord> answers);

/// The same from JSON. Throw CaseError.
AnswerRecord read_answer(const cases::JsonCursor& at);
std::vector<AnswerRecord> read_answers(const cases::JsonCursor& at);

/// One line of JSON, without its line break; `name` is what a place is called: "pose", "case".
std::string to_json(const PlaceRecord& record, std::string_view name);

/// The places that may stand in a line: all places come in their order, so that it is `next`.
struct ExpectedPlace {
  std::size_t next = 0;
  std::size_t end = 0;  ///< behind the last that there is
};
PlaceRecord read_place_record(const cases::JsonCursor& at, std::string_view name,
                              const ExpectedPlace& expected);

/// A number below `end`.
std::size_t read_place(const cases::JsonCursor& at, std::size_t end);
/// The number of the next place.
std::size_t read_place(const cases::JsonCursor& at, const ExpectedPlace& expected);

/// What is held against another run.
std::vector<SaidThere> said_there(const PlaceRecord& record);

}  // namespace graze::compare
