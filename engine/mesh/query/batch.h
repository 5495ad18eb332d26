#pragma once

// These answer many elements in one call: threads share them, and a user watches and stops that.
// They are private to the library.

#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/work.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>

namespace graze {

/// Follows a batch while it runs: how much is done, who is told, and whether it is to go on.
class BatchRun {
 public:
  BatchRun(std::size_t count, const BatchSettings& batch);

  std::size_t count() const { return count_; }
  const BatchSettings& settings() const { return batch_; }

  /// True if the user asked the batch to stop.
  bool is_stopped() const { return batch_.stop.stop_requested(); }

  /// Returns how many of so many elements may be answered before the next add(): all, but on a
  /// thread that tells of progress.
  std::size_t step(std::size_t remaining) const {
    return is_telling() ? std::min(remaining, step_) : remaining;
  }

  /// Notes that so many more are done, on whichever thread.
  void add(std::size_t elements) {
    done_.fetch_add(elements, std::memory_order_relaxed);
    if (is_telling()) look();
  }

  /// Ends the batch, once all parts have ended. Throws StoppedError if not all elements are done.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  bool is_telling() const { return batch_.on_progress && std::this_thread::get_id() == caller_; }
  void look();
  void tell(std::size_t done);

  const BatchSettings& batch_;
  const std::size_t count_;
  const std::thread::id caller_ = std::this_thread::get_id();
  const std::uint64_t users_word_;  ///< the control word of the caller, for what is called back
  std::atomic<std::size_t> done_ = 0;
  // The members below belong to the caller's thread alone.
  std::size_t step_ = 1;
  Clock::time_point looked_;
  Clock::time_point told_;
};

/// Calls `part(first, last, run, work)` for parts of the elements, of at most so many, on as many
/// threads as the settings say, and sums up `work`. Parts call run.add() for what they have
/// answered, and return early where run.is_stopped(). What they throw ends the batch. Throws
/// InputError for a negative number of threads, and StoppedError.
void for_each_part_of_batch(std::size_t count, std::size_t most_in_a_part,
                            const BatchSettings& batch, Work* total,
                            const std::function<void(std::size_t first, std::size_t last,
                                                     BatchRun& run, Work& work)>& part);

/// Calls `ask(i, work)` for each element in the same way.
template <typename Ask>
void for_each_in_batch(std::size_t count, std::size_t most_in_a_part, const BatchSettings& batch,
                       Work* total, const Ask& ask) {
  for_each_part_of_batch(count, most_in_a_part, batch, total,
                         [&](std::size_t first, std::size_t last, BatchRun& run, Work& work) {
                           for (std::size_t i = first; i < last;) {
                             const std::size_t begin = i;
                             const std::size_t end = i + run.step(last - i);
                             for (; i < end; ++i) {
                               if (run.is_stopped()) return;
                               ask(i, work);
                             }
                             run.add(end - begin);
                           }
                         });
}

}  // namespace graze
