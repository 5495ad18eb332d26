#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// Returns the columns of a CSV file of answers, from its second line. Throws CaseError, which
/// begins with `place`.
std::vector<std::string> answer_columns(std::string_view line, const std::string& place);

/// Returns a row of it as the JSON line of the same answer. Throws CaseError, which begins with
/// `place`.
std::string json_of_row(std::string_view row, const std::vector<std::string>& columns,
                        const std::string& place);

/// Refuses a line that is no answer to the pose of this number. Throws CaseError.
void check_answer_line(const cases::JsonCursor& at, std::size_t pose);

/// Returns what the line says was answered to `query`. Throws EngineFailure for what is no answer.
TimedAnswer heard_answer(const cases::JsonCursor& at, const Case& query);

}  // namespace graze::compare
