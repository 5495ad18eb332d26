#pragma once

// may_overlap() for oriented boxes, a SIMD width at a time, operation by operation the same: so are
// its answers, on every SIMD target. Plain arrays at the border, as in kdop_kernels.h.

#include <graze/narrowphase/volumes/obb_rows.h>
#include <graze/narrowphase/volumes/volume_rows.h>
#include <cstddef>
#include <cstdint>

namespace graze::narrowphase {

/// One box against element i of many.
void find_overlaps(const ObbRow& one, const RowPointers<kObbRows>& many, std::size_t count,
                   std::uint8_t* hits);

/// Elements i of both.
void find_overlaps(const RowPointers<kObbRows>& a, const RowPointers<kObbRows>& b,
                   std::size_t count, std::uint8_t* hits);

}  // namespace graze::narrowphase
