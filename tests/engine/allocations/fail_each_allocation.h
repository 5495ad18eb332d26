#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tests/engine/allocations/failing_new.h"

namespace graze::tests {

/// Lets each allocation of a task fail once, about 120 of them at most: std::bad_alloc comes out or
/// the task ends, nothing is leaked, and `check` is told which. `begin` is called before each.
template <typename Task, typename Check>
void fail_each_allocation_of_files(
    const std::string& name, const Task& task, const Check& check,
    const std::function<void()>& begin = [] {}) {
  task();
  const long count = allocations_of(task);
  EXPECT_GT(count, 0) << name;
  for (long n = 1; n <= count; n = next_failure(n, count, 120)) {
    begin();
    const long before = live_blocks();
    const Attempt made = attempt(n, task);
    EXPECT_TRUE(made.has_failed) << name << ", allocation " << n;
    EXPECT_EQ(live_blocks(), before) << name << ", allocation " << n;
    check(made);
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << name << ", allocation " << n;
      return;
    }
  }
}

}  // namespace graze::tests
