#pragma once

// Pages of 2 MiB for what is read here and there: in those of 4 KiB a ray would miss their table as
// often as the cache. Private.

#include <cstddef>
#include <new>

namespace graze::bvh {

inline constexpr std::align_val_t kLargePage{std::size_t{1} << 21};

/// Asks for large pages for memory that is aligned to one and has not been written to. Nothing
/// where there is little of it; where it is refused, pages are small.
void ask_for_large_pages(void* memory, std::size_t bytes);

/// Moves memory that is in use into large pages, as far as it fills these, likewise. Its addresses
/// and what it holds stay: others may read meanwhile. Microseconds a page.
void move_to_large_pages(const void* memory, std::size_t bytes);

}  // namespace graze::bvh
