#pragma once

#include <string>

#include <graze/engine/cases/json_cursor.h>
#include <graze/engine/compare/run/comparison.h>

namespace graze::compare {

/// One answer and its judgement as a JSON object.
std::string to_json(const AnswerRecord& answer);

/// The same from JSON. Throws CaseError.
AnswerRecord read_answer(const cases::JsonCursor& at);

/// The names of the engines that are here, as a JSON list.
std::string engine_names_json(std::span<const EngineEntry> engines);

}  // namespace graze::compare
