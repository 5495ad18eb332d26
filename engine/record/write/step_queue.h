#pragma once

#include <graze/engine/record/world_recorder.h>
#include <graze/engine/record/write/step_notes.h>
#include <graze/engine/record/write/step_writer.h>

#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

namespace graze::record {

/// Holds notes of updates, which wait for a thread of their own to write them, or are written at
/// once. One thread may use the queue; it starts another.
class StepQueue {
 public:
  StepQueue(StepWriter::Sink sink, RecordedWriting writing);
  ~StepQueue();
  StepQueue(const StepQueue&) = delete;
  StepQueue& operator=(const StepQueue&) = delete;

  /// Returns the notes of what is done until the next submit().
  StepNotes& notes() { return *notes_; }

  /// Hands the notes over to be written, and begins new ones; waits while many wait. Throws what
  /// went wrong with earlier ones: after that nothing is written.
  void submit();
  /// Writes blocks as they are, once all that waits is written. Throws as submit() does.
  void hand_over(std::string_view blocks);
  /// Writes what waits and takes no more notes.
  void close() noexcept;

  // These functions wait until all that was submitted is written, unless the thread that writes
  // asks.
  bool has_failed() const noexcept;  ///< true if anything went wrong
  std::size_t updates() const;       ///< the number of updates that were written
  std::uint64_t bytes() const;       ///< the number of bytes that were written

 private:
  /// So many updates may wait; a world that is quicker than its recorder waits for it.
  static constexpr std::size_t kMostWaiting = 3;

  bool start();
  void run() noexcept;
  void wait_until_idle(std::unique_lock<std::mutex>& lock) const;
  void rethrow_failure() const;

  StepWriter writer_;  ///< belongs to the thread while anything waits
  std::unique_ptr<StepNotes> notes_ = std::make_unique<StepNotes>();
  RecordedWriting writing_;

  mutable std::mutex mutex_;  ///< guards all that follows
  mutable std::condition_variable has_changed_;
  std::deque<std::unique_ptr<StepNotes>> waiting_;  ///< the first of them is being written
  std::vector<std::unique_ptr<StepNotes>> free_;
  std::exception_ptr failure_;
  bool is_closed_ = false;
  std::thread thread_;
};

}  // namespace graze::record
