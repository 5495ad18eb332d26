#pragma once

// How queries use threads. Private to engine/mesh.

#include <cstddef>
#include <functional>

namespace graze {

/// Throws InputError for a number of threads below 0.
void check_threads(int threads);

/// Calls `part(i)` for each i below `count`, with so many threads at most (0: all that there are;
/// 1: this one, in order). Isolated: a thread that waits here takes up nothing but these calls.
/// What a call throws ends the rest and reaches the caller.
void for_each_part(std::size_t count, int threads, const std::function<void(std::size_t)>& part);

/// How many threads that is at most.
std::size_t thread_count(int threads);

}  // namespace graze
