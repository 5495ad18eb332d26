// Replaces every operator of the whole program, as tests/engine/body_world/allocations.cpp does.

#include "tests/engine/allocations/failing_new.h"

#include <atomic>
#include <cstdlib>

namespace {

std::atomic<long> live = 0;
std::atomic<bool> is_armed = false;
std::atomic<long> calls = 0;
std::atomic<long> due = 0;
std::atomic<bool> has_failed = false;

/// Whether this call is the one that fails.
bool is_due() noexcept {
  if (!is_armed || ++calls != due) return false;
  has_failed = true;
  return true;
}

void* counted(void* block) noexcept {
  if (block != nullptr) ++live;
  return block;
}

void release(void* block) noexcept {
  if (block != nullptr) --live;
  std::free(block);
}

void* allocate(std::size_t size) noexcept {
  return is_due() ? nullptr : counted(std::malloc(size == 0 ? 1 : size));
}

void* allocate(std::size_t size, std::align_val_t alignment) noexcept {
  const auto step = static_cast<std::size_t>(alignment);
  return is_due() ? nullptr : counted(std::aligned_alloc(step, (size / step + 1) * step));
}

void* or_throw(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

}  // namespace

void* operator new(std::size_t size) {
  return or_throw(allocate(size));
}
void* operator new[](std::size_t size) {
  return or_throw(allocate(size));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return or_throw(allocate(size, alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return or_throw(allocate(size, alignment));
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(size, alignment);
}

void operator delete(void* block) noexcept {
  release(block);
}
void operator delete[](void* block) noexcept {
  release(block);
}
void operator delete(void* block, std::size_t) noexcept {
  release(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  release(block);
}
void operator delete(void* block, const std::nothrow_t&) noexcept {
  release(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept {
  release(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  release(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
  release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  release(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
  release(block);
}
void operator delete(void* block, std::align_val_t, const std::nothrow_t&) noexcept {
  release(block);
}
void operator delete[](void* block, std::align_val_t, const std::nothrow_t&) noexcept {
  release(block);
}

namespace graze::tests {

long live_blocks() {
  return live;
}

FailingNew::FailingNew(long at) {
  ::calls = 0;
  due = at;
  ::has_failed = false;
  is_armed = true;
}

FailingNew::~FailingNew() {
  is_armed = false;
}

long FailingNew::calls() const {
  return ::calls;
}

bool FailingNew::has_failed() const {
  return ::has_failed;
}

}  // namespace graze::tests
