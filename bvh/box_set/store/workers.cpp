#include <graze/bvh/box_set/store/workers.h>

#include <graze/bvh/box_set/store/fork.h>

#include <algorithm>

namespace graze::bvh {
namespace {

constexpr int kMostThreads = 256;  // oneTBB crashes where it has no memory for as many as asked

}  // namespace

Workers::Workers(int threads) {
  if (threads > 1) arena_ = std::make_unique<tbb::task_arena>(std::min(threads, kMostThreads));
}

void Workers::share_out(std::size_t chunks, const OpaqueWork& work) const {
  arena_->execute([&] { fork_each(chunks, work); });
}

void Workers::run_forking(const OpaqueWork& work) const {
  // An arena may hand the work to another thread.
  const auto computed = [&work] { in_standard_arithmetic([&] { work(0); }); };
  if (arena_ == nullptr) {
    tbb::task_arena(1).execute(computed);
  } else {
    arena_->execute(computed);
  }
}

}  // namespace graze::bvh
