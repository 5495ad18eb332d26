#pragma once

// Memory that is read here and there is put into pages of 2 MiB: in those of 4 KiB a ray would miss
// their table as often as the cache. This is private.

#include <cstddef>
#include <new>

namespace graze::bvh {

inline constexpr std::align_val_t kLargePage{std::size_t{1} << 21};

/// Asks for large pages for memory that is aligned to one and has not been written to. It does
/// nothing where there is little memory; where it is refused, pages stay small.
void ask_for_large_pages(void* memory, std::size_t bytes);

/// Moves memory that is in use into large pages, as far as it fills these, under the same
/// conditions. Its addresses and contents stay: others may read meanwhile. It takes microseconds a
/// page.
void move_to_large_pages(const void* memory, std::size_t bytes);

}  // namespace graze::bvh
