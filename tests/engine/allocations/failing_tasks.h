#pragma once

namespace graze::tests {

/// While one lives, oneTBB's allocations of tasks are counted, and the chosen one throws
/// std::bad_alloc, as oneTBB itself does where it finds no memory, whichever thread asks. One at a
/// time.
class FailingTasks {
 public:
  static constexpr long kNever = 0;

  /// `at` counts from 1.
  explicit FailingTasks(long at);
  ~FailingTasks();
  FailingTasks(const FailingTasks&) = delete;
  FailingTasks& operator=(const FailingTasks&) = delete;

  long calls() const;
  bool has_failed() const;
};

}  // namespace graze::tests
