#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/parallel.h>
#include <graze/engine/mesh/query/threads.h>

#include <tbb/task_arena.h>

#include <algorithm>
#include <string>

namespace graze {

void check_threads(int threads) {
  if (threads >= 0) return;
  throw InputError("threads: " + std::to_string(threads) + " is not a number of threads");
}

void run_in_arena(int threads, const std::function<void()>& body) {
  const auto computed = [&] { bvh::in_standard_arithmetic([&] { body(); }); };
  if (threads == 0 || threads >= tbb::this_task_arena::max_concurrency()) {
    tbb::this_task_arena::isolate(computed);
  } else {
    // An arena of its own keeps other work out, as isolation does. To make one takes a tenth of a
    // short query's time.
    tbb::task_arena arena(threads);
    arena.execute(computed);
  }
}

void for_each_part(std::size_t count, int threads, const std::function<void(std::size_t)>& part) {
  if (threads == 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i)
      part(i);
    return;
  }
  run_in_arena(threads, [&] {
    // Parts differ in cost, and are few: they are handed out one at a time.
    bvh::for_in_parallel(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          bvh::in_standard_arithmetic([&] {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
              part(i);
          });
        },
        tbb::simple_partitioner());
  });
}

std::size_t thread_count(int threads) {
  constexpr int kMost = 1024;  // more would only ask for memory
  return static_cast<std::size_t>(threads > 0 ? std::min(threads, kMost)
                                              : tbb::this_task_arena::max_concurrency());
}

}  // namespace graze
