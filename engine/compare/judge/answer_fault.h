#pragma once

#include <optional>
#include <string>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>

namespace graze::compare {

/// Why what an engine returned is no answer to the question, in words: "names triangle 99 of 12", a
/// list that does not ascend, a number that is none, an answer to another question. Nothing if it
/// is one, right or wrong.
std::optional<std::string> fault_of_answer(const Case& query, const CaseAnswer& answer);

/// The judgement on what is no answer: wrong, whatever is true.
Judgement engine_error(const std::string& why);

}  // namespace graze::compare
