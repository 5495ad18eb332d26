#include <graze/bvh/rays/large_pages.h>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <memory>

namespace graze::bvh {

#ifdef __linux__

namespace {

constexpr std::size_t kWorthLargePages = std::size_t{1} << 22;

// The number of MADV_COLLAPSE in Linux 6.1 and later; older headers do not name it, and older
// kernels refuse it.
constexpr int kCollapse = 25;

}  // namespace

void ask_for_large_pages(void* memory, std::size_t bytes) {
  if (bytes >= kWorthLargePages) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
}

void move_to_large_pages(const void* memory, std::size_t bytes) {
  if (bytes < kWorthLargePages) return;
  constexpr auto kPage = static_cast<std::size_t>(kLargePage);
  void* first = const_cast<void*>(memory);  // nothing is written
  if (std::align(kPage, kPage, first, bytes) != nullptr)
    static_cast<void>(madvise(first, bytes / kPage * kPage, kCollapse));
}

#else

void ask_for_large_pages(void*, std::size_t) {}
void move_to_large_pages(const void*, std::size_t) {}

#endif

}  // namespace graze::bvh
