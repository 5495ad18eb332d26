#pragma once

#include <new>

namespace graze::tests {

/// How many blocks this program holds by any operator new.
long live_blocks();

/// While one lives, operator new counts its calls, and the chosen one fails, whichever thread makes
/// it. One at a time.
class FailingNew {
 public:
  static constexpr long kNever = 0;

  /// `at` counts from 1.
  explicit FailingNew(long at);
  ~FailingNew();
  FailingNew(const FailingNew&) = delete;
  FailingNew& operator=(const FailingNew&) = delete;

  long calls() const;
  bool has_failed() const;
};

/// Whether the task came to its end with the n-th allocation failing; false if std::bad_alloc came
/// out. Any other exception is passed on, and fails the test.
struct Attempt {
  bool has_ended = false;   // and not thrown
  bool has_failed = false;  // an allocation
};
template <typename Task>
Attempt attempt(long n, const Task& task) {
  Attempt made;
  const FailingNew armed(n);
  try {
    task();
    made.has_ended = true;
  } catch (const std::bad_alloc&) {
  }
  made.has_failed = armed.has_failed();
  return made;
}

/// How often the task calls operator new.
template <typename Task>
long allocations_of(const Task& task) {
  const FailingNew counting(FailingNew::kNever);
  task();
  return counting.calls();
}

/// The next allocation to fail: each of the first, and from there on about `most` in all.
inline long next_failure(long n, long count, long most) {
  return n + (n < most / 2 ? 1 : 1 + 2 * count / most);
}

}  // namespace graze::tests
