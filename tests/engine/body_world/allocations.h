#pragma once

#include <cstddef>

namespace graze::tests {

/// How many blocks this program has asked any operator new for so far.
std::size_t allocations();

}  // namespace graze::tests
