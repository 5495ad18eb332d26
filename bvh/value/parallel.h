#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <utility>

namespace graze::bvh {

// A loop of oneTBB's belongs by default to the group of tasks from within which it is called: where
// one of those throws, or a user cancels them, the loop leaves out what it has not begun, and
// returns as if it had done all. A tree that is built meanwhile, for all who will ever ask its
// mesh, would be what memory held before. So each loop is a group of its own: what is left out of
// it is told by an exception of its own.

/// Calls tbb::parallel_for() such that nobody cancels it from outside. It has a name of its own: by
/// the same one oneTBB would find it.
template <typename... Arguments>
void for_in_parallel(Arguments&&... arguments) {
  tbb::task_group_context alone(tbb::task_group_context::isolated);
  tbb::parallel_for(std::forward<Arguments>(arguments)..., alone);
}

/// Calls tbb::parallel_reduce() in the same way.
template <typename... Arguments>
auto reduce_in_parallel(Arguments&&... arguments) {
  tbb::task_group_context alone(tbb::task_group_context::isolated);
  return tbb::parallel_reduce(std::forward<Arguments>(arguments)..., alone);
}

}  // namespace graze::bvh
