#pragma once

#include <string>
#include <vector>

#include <graze/engine/cases/case.h>

#include "tests/shapes/random_source.h"

namespace graze::compare {

/// An answer with something wrong in it on purpose.
struct AnswerMutant {
  std::string what;  ///< "contacts: normal reversed"
  CaseAnswer answer;
};

/// Every way to spoil this answer: signs, lengths, points, ids, and lists that are shorter, longer
/// or in disorder. Where something is drawn, from the source.
std::vector<AnswerMutant> mutants_of(const CaseAnswer& answer, RandomSource& source);

}  // namespace graze::compare
