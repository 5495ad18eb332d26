#include <tests/engine/mesh_io/allocated_bytes.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> allocated = 0;

}  // namespace

// Replaces the operator of the whole program. The forms for arrays end here too; sanitizers have
// one of their own for that without exceptions. It goes through malloc, so that sanitizers still
// see every block.
void* operator new(std::size_t size) {
  allocated += size;
  void* block = std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  allocated += size;
  return std::malloc(size == 0 ? 1 : size);
}

void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}

namespace graze::mesh_io {

std::size_t allocated_bytes() {
  return allocated;
}

}  // namespace graze::mesh_io
