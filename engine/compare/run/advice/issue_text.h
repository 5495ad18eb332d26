#pragma once

#include <string>

#include <graze/engine/compare/run/advice/advice.h>

namespace graze::compare {

/// Returns the text of an issue about one kind of wrong answer, in Markdown, with its title in the
/// first line: what was asked, what is true and why that is sure, what the engine says, the numbers
/// of the least case, and the command that asks again.
std::string issue_text(const WrongKind& kind);

}  // namespace graze::compare
