#pragma once

// Answers may_overlap() for oriented boxes, a SIMD width at a time. Operation by operation the
// arithmetic is the same, and so are the answers, on every SIMD target. Callers hand over plain
// arrays, as in kdop_kernels.h.

#include <graze/narrowphase/volumes/obb_rows.h>
#include <graze/narrowphase/volumes/volume_rows.h>
#include <cstddef>
#include <cstdint>

namespace graze::narrowphase {

/// Tests one box against element i of many.
void find_overlaps(const ObbRow& one, const RowPointers<kObbRows>& many, std::size_t count,
                   std::uint8_t* hits);

/// Tests element i of one against element i of the other.
void find_overlaps(const RowPointers<kObbRows>& a, const RowPointers<kObbRows>& b,
                   std::size_t count, std::uint8_t* hits);

}  // namespace graze::narrowphase
