#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/record/write/step_queue.h>

#include <system_error>
#include <utility>

namespace graze::record {

StepQueue::StepQueue(StepWriter::Sink sink, RecordedWriting writing)
    : writer_(std::move(sink)), writing_(writing) {
  free_.reserve(kMostWaiting + 1);
}

StepQueue::~StepQueue() {
  close();
}

/// Starts the thread. Where the system has no thread left, updates are written at once.
bool StepQueue::start() {
  if (writing_ == RecordedWriting::AtOnce) return false;
  if (thread_.joinable()) return true;
  try {
    thread_ = std::thread([this] { run(); });
  } catch (const std::system_error&) {
    writing_ = RecordedWriting::AtOnce;
  }
  return thread_.joinable();
}

void StepQueue::run() noexcept {
  std::unique_lock lock(mutex_);
  while (true) {
    has_changed_.wait(lock, [this] { return !waiting_.empty() || is_closed_; });
    if (waiting_.empty()) return;
    if (failure_ == nullptr) {
      const StepNotes& notes = *waiting_.front();
      lock.unlock();
      std::exception_ptr failure;
      try {
        bvh::in_standard_arithmetic([&] { writer_.write(notes); });
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      failure_ = std::move(failure);
    }
    waiting_.front()->clear();
    free_.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
    has_changed_.notify_all();
  }
}

void StepQueue::submit() {
  if (!start()) {
    rethrow_failure();
    writer_.write(*notes_);
    notes_->clear();
    return;
  }
  std::unique_lock lock(mutex_);
  has_changed_.wait(lock, [this] { return waiting_.size() < kMostWaiting; });
  rethrow_failure();
  std::unique_ptr<StepNotes> next;
  if (free_.empty()) {
    next = std::make_unique<StepNotes>();
  } else {
    next = std::move(free_.back());
    free_.pop_back();
  }
  waiting_.push_back(std::move(notes_));
  notes_ = std::move(next);
  lock.unlock();
  has_changed_.notify_all();
}

void StepQueue::hand_over(std::string_view blocks) {
  std::unique_lock lock(mutex_);
  wait_until_idle(lock);
  rethrow_failure();
  lock.unlock();
  writer_.hand_over(blocks);
}

void StepQueue::close() noexcept {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
  }
  has_changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  writer_.close();
}

bool StepQueue::has_failed() const noexcept {
  std::unique_lock lock(mutex_);
  wait_until_idle(lock);
  return failure_ != nullptr;
}

std::size_t StepQueue::updates() const {
  std::unique_lock lock(mutex_);
  wait_until_idle(lock);
  return writer_.updates();
}

std::uint64_t StepQueue::bytes() const {
  std::unique_lock lock(mutex_);
  wait_until_idle(lock);
  return writer_.bytes();
}

/// Waits until all is written. The sink may ask, from the thread that writes, and is told what is
/// written then.
void StepQueue::wait_until_idle(std::unique_lock<std::mutex>& lock) const {
  if (std::this_thread::get_id() == thread_.get_id()) return;
  has_changed_.wait(lock, [this] { return waiting_.empty(); });
}

void StepQueue::rethrow_failure() const {
  if (failure_ != nullptr) std::rethrow_exception(failure_);
}

}  // namespace graze::record
