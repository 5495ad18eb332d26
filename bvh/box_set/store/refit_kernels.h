#pragma once

// Bounds of blocks, once for each SIMD target, alike on all of them.

#include <graze/bvh/box_set/store/block.h>

#include <cstdint>

namespace graze::bvh {

/// Writes the bounds of blocks [first, last) of one level into their lanes of the level above.
void refit_blocks(const Block* below, std::uint32_t first, std::uint32_t last, Block* above);

}  // namespace graze::bvh
