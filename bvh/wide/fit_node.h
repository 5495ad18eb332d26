#pragma once

#include <graze/bvh/wide/corner_rows.h>
#include <graze/bvh/wide/range_moments.h>
#include <graze/bvh/wide/wide_node.h>

#include <cstdint>
#include <span>

namespace graze::bvh {

/// Consecutive primitives, from `begin` to before `end`.
struct PrimitiveRange {
  std::uint32_t begin;
  std::uint32_t end;
};

/// Half the surfaces of the boxes of a node's children, and of the box of all, in square local
/// units.
struct FittedSurfaces {
  float children = 0;
  float all = 0;
};

/// Sets the axes, the origin and the boxes of a node whose children hold these ranges, which stand
/// one behind the other: along the coordinate axes or those of axes_of(), whichever makes the
/// boxes' surfaces smaller. Rows are coordinates less `rows_origin`.
FittedSurfaces fit_node(const CornerRows& rows, const MomentSums& sums,
                        std::span<const PrimitiveRange> children, const double (&rows_origin)[3],
                        WideNode& node);

/// Sets the origin and the boxes of a node for other corners of its primitives, along the axes that
/// it has.
FittedSurfaces refit_node(const CornerRows& rows, std::span<const PrimitiveRange> children,
                          const double (&rows_origin)[3], WideNode& node);

}  // namespace graze::bvh
