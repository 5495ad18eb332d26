#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>
#include <array>
#include <cstddef>

namespace graze::narrowphase {

/// The numbers that the test knows of an oriented box, in the order of kernels' rows: the sum of
/// its half extents; half extents 1 to 3; translation 4 to 6; the matrix's columns, 7 to 15; its
/// deviation from a rotation.
inline constexpr std::size_t kObbRows = 17;
using ObbRow = std::array<double, kObbRows>;

inline constexpr std::size_t kSumRow = 0;
inline constexpr std::size_t kHalfRow = 1;
inline constexpr std::size_t kTranslationRow = 4;
inline constexpr std::size_t kAxisRow = 7;
inline constexpr std::size_t kDeviationRow = 16;

/// Return the row of a valid box; the second takes the deviation from a rotation that
/// bvh::check_box() has returned.
ObbRow row_of(const Obb& box);
ObbRow row_of(const Obb& box, double deviation);
Obb obb_of(const ObbRow& row);

/// True if the second of two boxes is to be A: the larger one is, as the slack charges B's size
/// more; of equal ones, by the first number that differs. So the test does not depend on the order
/// of its arguments.
bool is_second_first(const ObbRow& box_a, const ObbRow& box_b);

/// False only if the boxes are apart for sure (obb_slack.h).
bool may_overlap(const ObbRow& box_a, const ObbRow& box_b);
bool may_overlap(const Aabb& aligned, const ObbRow& oriented);

}  // namespace graze::narrowphase
