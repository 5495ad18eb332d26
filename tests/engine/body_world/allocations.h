#pragma once

#include <cstddef>

namespace graze::tests {

/// How many blocks this program has asked any operator new for so far.
std::size_t allocations();

/// The bytes of all blocks that it holds by them now.
std::size_t allocated_bytes();

/// The most that these were since the last call.
std::size_t most_allocated_bytes();

}  // namespace graze::tests
