#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/dot.h>
#include <graze/bvh/value/rigid.h>
#include <graze/bvh/value/separating_axes.h>
#include <graze/narrowphase/volumes/boxes/obb_pair_kernels.h>
#include <graze/narrowphase/volumes/boxes/obb_slack.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <graze/narrowphase/volumes/obb_rows.h>
#include <cmath>
#include <limits>

namespace graze {
namespace narrowphase {
namespace {

using bvh::dot;

double slack(double sum_a, double deviation_a, double sum_b, double deviation_b) {
  if (!(sum_a + sum_b <= kLargestObbSum)) return std::numeric_limits<double>::infinity();
  const double deviating = deviation_a * (kDeviationOfA * sum_a + kDeviationOfAOnB * sum_b) +
                           deviation_b * (kDeviationOfB * sum_b);
  return (deviating + (kRoundingOfA * sum_a + kRoundingOfB * sum_b)) + kObbUnderflow;
}

bool may_overlap_in_order(const ObbRow& a, const ObbRow& b) {
  double between[3], rotation[3][3], size[3][3], offset[3];
  for (std::size_t k = 0; k < 3; ++k)
    between[k] = b[kTranslationRow + k] - a[kTranslationRow + k];
  for (std::size_t i = 0; i < 3; ++i) {
    const double* axis = &a[kAxisRow + 3 * i];
    offset[i] = dot(axis, between);
    for (std::size_t j = 0; j < 3; ++j) {
      rotation[i][j] = dot(axis, &b[kAxisRow + 3 * j]);
      size[i][j] = std::abs(rotation[i][j]);
    }
  }
  const double half_a[3] = {a[kHalfRow], a[kHalfRow + 1], a[kHalfRow + 2]};
  const double half_b[3] = {b[kHalfRow], b[kHalfRow + 1], b[kHalfRow + 2]};
  return !bvh::are_boxes_apart({rotation, size, offset, half_a, half_b},
                               slack(a[kSumRow], a[kDeviationRow], b[kSumRow], b[kDeviationRow]));
}

}  // namespace

ObbRow row_of(const Obb& box, double deviation) {
  const double* half = box.half_extents.data();
  const double* m = box.pose.data();  // column-major 4x4
  ObbRow row;
  row[kSumRow] = (half[0] + half[1]) + half[2];
  for (std::size_t i = 0; i < 3; ++i) {
    row[kHalfRow + i] = half[i];
    row[kTranslationRow + i] = m[12 + i];
    for (std::size_t k = 0; k < 3; ++k)
      row[kAxisRow + 3 * i + k] = m[4 * i + k];
  }
  row[kDeviationRow] = deviation;
  return row;
}

ObbRow row_of(const Obb& box) {
  return row_of(box, bvh::RotationError(box.pose).largest());
}

Obb obb_of(const ObbRow& row) {
  Obb box{Pose::Identity(), {row[kHalfRow], row[kHalfRow + 1], row[kHalfRow + 2]}};
  double* m = box.pose.data();
  for (std::size_t i = 0; i < 3; ++i) {
    m[12 + i] = row[kTranslationRow + i];
    for (std::size_t k = 0; k < 3; ++k)
      m[4 * i + k] = row[kAxisRow + 3 * i + k];
  }
  return box;
}

bool is_second_first(const ObbRow& box_a, const ObbRow& box_b) {
  for (std::size_t r = 0; r < kDeviationRow; ++r) {
    if (box_a[r] != box_b[r]) return box_a[r] < box_b[r];
  }
  return false;
}

bool may_overlap(const ObbRow& box_a, const ObbRow& box_b) {
  return is_second_first(box_a, box_b) ? may_overlap_in_order(box_b, box_a)
                                       : may_overlap_in_order(box_a, box_b);
}

// All is in the frame of the aligned box, which is A.
bool may_overlap(const Aabb& aligned, const ObbRow& oriented) {
  double rotation[3][3], size[3][3], offset[3], half_a[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const double low = aligned.min.data()[i] - oriented[kTranslationRow + i];
    const double high = aligned.max.data()[i] - oriented[kTranslationRow + i];
    offset[i] = -0.5 * (low + high);
    half_a[i] = 0.5 * (aligned.max.data()[i] - aligned.min.data()[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      rotation[i][j] = oriented[kAxisRow + 3 * j + i];
      size[i][j] = std::abs(rotation[i][j]);
    }
  }
  const double half_b[3] = {oriented[kHalfRow], oriented[kHalfRow + 1], oriented[kHalfRow + 2]};
  const double sum_a = (half_a[0] + half_a[1]) + half_a[2];
  return !bvh::are_boxes_apart({rotation, size, offset, half_a, half_b},
                               slack(sum_a, 0, oriented[kSumRow], oriented[kDeviationRow]));
}

}  // namespace narrowphase

using narrowphase::ObbPairAnswer;

bool intersects(const Obb& box_a, const Obb& box_b) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    const ObbPairAnswer answer = narrowphase::look_at_pair(box_a, box_b);
    if (answer != ObbPairAnswer::Open) [[likely]]
      return answer == ObbPairAnswer::MayOverlap;
    const double deviation_a = bvh::check_box(box_a, "box a");
    const double deviation_b = bvh::check_box(box_b, "box b");
    return narrowphase::may_overlap(narrowphase::row_of(box_a, deviation_a),
                                    narrowphase::row_of(box_b, deviation_b));
  });
}

bool intersects(const Aabb& aligned, const Obb& oriented) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_box(aligned, "aligned box");
    const double deviation = bvh::check_box(oriented, "oriented box");
    return narrowphase::may_overlap(aligned, narrowphase::row_of(oriented, deviation));
  });
}

bool intersects(const Obb& oriented, const Aabb& aligned) {
  return intersects(aligned, oriented);
}

}  // namespace graze
