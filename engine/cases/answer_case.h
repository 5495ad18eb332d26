#pragma once

#include <graze/engine/cases/case.h>
#include <graze/engine/work.h>

namespace graze {

/// Asks the library the question of a case again. Throws InputError for a question that no query
/// answers for such shapes, and passes on what the query throws.
CaseAnswer answer_case(const Case& query, Work* work = nullptr);

/// Returns the name and version of this library, as it signs answers.
CaseWitness this_library();

}  // namespace graze
