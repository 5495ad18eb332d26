#pragma once

// This is how queries use threads. It is private to the library.

#include <cstddef>
#include <functional>

namespace graze {

/// Throws InputError for a number of threads below 0.
void check_threads(int threads);

/// Calls `body`, whose tasks so many threads at most work on; 0 means all that there are. It is
/// isolated: a thread that waits in there takes up nothing else.
void run_in_arena(int threads, const std::function<void()>& body);

/// Calls `part(i)` for each i below `count`, in such an arena; with one thread in order. What a
/// call throws ends the rest and reaches the caller.
void for_each_part(std::size_t count, int threads, const std::function<void(std::size_t)>& part);

/// Returns how many threads that is at most.
std::size_t thread_count(int threads);

}  // namespace graze
