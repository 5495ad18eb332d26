// oneTBB gives tasks memory of its own, by no operator new. So the function that does stands here,
// too, and goes before the one of oneTBB's library, which it calls.

#include "tests/engine/allocations/failing_tasks.h"

#include <dlfcn.h>
#include <oneapi/tbb/detail/_small_object_pool.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> is_armed = false;
std::atomic<long> asked = 0;
std::atomic<long> due = 0;
std::atomic<bool> was_due = false;

void fail_if_due() {
  if (!is_armed || ++asked != due) return;
  was_due = true;
  throw std::bad_alloc();
}

template <typename Function>
Function* of_library(const char* name) {
  auto* found = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
  if (found == nullptr) std::abort();
  return found;
}

}  // namespace

namespace tbb::detail::r1 {

void* __TBB_EXPORTED_FUNC allocate(d1::small_object_pool*& pool, std::size_t bytes,
                                   const d1::execution_data& data) {
  static auto* const library =
      of_library<void*(d1::small_object_pool*&, std::size_t, const d1::execution_data&)>(
          "_ZN3tbb6detail2r18allocateERPNS0_2d117small_object_poolEmRKNS2_14execution_dataE");
  fail_if_due();
  return library(pool, bytes, data);
}

void* __TBB_EXPORTED_FUNC allocate(d1::small_object_pool*& pool, std::size_t bytes) {
  static auto* const library = of_library<void*(d1::small_object_pool*&, std::size_t)>(
      "_ZN3tbb6detail2r18allocateERPNS0_2d117small_object_poolEm");
  fail_if_due();
  return library(pool, bytes);
}

}  // namespace tbb::detail::r1

namespace graze::tests {

FailingTasks::FailingTasks(long at) {
  asked = 0;
  due = at;
  was_due = false;
  is_armed = true;
}

FailingTasks::~FailingTasks() {
  is_armed = false;
}

long FailingTasks::calls() const {
  return asked;
}

bool FailingTasks::has_failed() const {
  return was_due;
}

}  // namespace graze::tests
