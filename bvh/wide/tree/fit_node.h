#pragma once

#include <graze/bvh/wide/tree/corner_rows.h>
#include <graze/bvh/wide/tree/range_moments.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <cstdint>
#include <span>

namespace graze::bvh {

/// Consecutive primitives, from `begin` to before `end`.
struct PrimitiveRange {
  std::uint32_t begin;
  std::uint32_t end;
};

/// Sets the axes, the origin and the boxes of a node whose children hold these ranges, which stand
/// one behind the other: along the coordinate axes or those of axes_of(), whichever makes the
/// boxes' surfaces smaller. Rows are coordinates less `rows_origin`. Returns half the sum of these
/// surfaces, in square local units.
float fit_node(const CornerRows& rows, const MomentSums& sums,
               std::span<const PrimitiveRange> children, const double (&rows_origin)[3],
               WideNode& node);

/// Does the same along the axes that the node has, for other corners of its primitives.
float refit_node(const CornerRows& rows, std::span<const PrimitiveRange> children,
                 const double (&rows_origin)[3], WideNode& node);

}  // namespace graze::bvh
