#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/query/batch.h>
#include <graze/engine/mesh/query/threads.h>

#include <mutex>

namespace graze {
namespace {

/// The least number of parts for each thread, where there are elements enough.
constexpr std::size_t kPartsPerThread = 16;

/// The time between two reports of progress to the user.
constexpr std::chrono::milliseconds kBetweenReports{50};
/// A step that takes longer than this is made element by element.
constexpr std::chrono::milliseconds kLongStep{2};
/// The most elements between two looks at the clock, which takes a quarter of what the shortest
/// query does.
constexpr std::size_t kLongestStep = 32;

}  // namespace

BatchRun::BatchRun(std::size_t count, const BatchSettings& batch)
    : batch_(batch), count_(count), users_word_(bvh::users_control_word()) {
  if (batch_.on_progress) looked_ = Clock::now();
}

void BatchRun::look() {
  const Clock::time_point now = Clock::now();
  step_ = now - looked_ > kLongStep ? 1 : std::min(4 * step_, kLongestStep);
  looked_ = now;
  const std::size_t done = done_.load(std::memory_order_relaxed);
  if (done == count_ || now - told_ < kBetweenReports) return;
  told_ = now;
  tell(done);
}

void BatchRun::tell(std::size_t done) {
  bvh::in_users_arithmetic(users_word_, [&] { batch_.on_progress(done, count_); });
}

void BatchRun::finish() {
  const std::size_t done = done_.load();
  if (done != count_) throw StoppedError(done, count_);
  if (batch_.on_progress && count_ > 0) tell(count_);
}

void for_each_part_of_batch(std::size_t count, std::size_t most_in_a_part,
                            const BatchSettings& batch, Work* total,
                            const std::function<void(std::size_t first, std::size_t last,
                                                     BatchRun& run, Work& work)>& part) {
  check_threads(batch.threads);
  BatchRun run(count, batch);
  const std::size_t parts = thread_count(batch.threads) * kPartsPerThread;
  const std::size_t size = std::clamp(count / parts, std::size_t{1}, most_in_a_part);
  std::mutex mutex;
  for_each_part((count + size - 1) / size, batch.threads, [&](std::size_t index) {
    if (run.is_stopped()) return;
    Work work;
    part(index * size, std::min((index + 1) * size, count), run, work);
    if (total == nullptr) return;
    const std::scoped_lock lock(mutex);
    *total += work;
  });
  run.finish();
}

}  // namespace graze
