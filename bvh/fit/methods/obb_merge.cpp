#include <graze/bvh/error.h>
#include <graze/bvh/fit/obb_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>

#include <algorithm>
#include <array>
#include <limits>

namespace graze {
namespace {

constexpr double kLeast = std::numeric_limits<double>::denorm_min();

/// Writes the eight corners t + R y, rounded.
void write_corners(const Obb& box, Eigen::Vector3d* corners) {
  for (int i = 0; i < 8; ++i) {
    Eigen::Vector3d y = box.half_extents;
    for (int k = 0; k < 3; ++k) {
      if ((i >> k & 1) != 0) y.data()[k] = -y.data()[k];
    }
    for (int k = 0; k < 3; ++k) {
      const double* m = box.pose.data() + k;
      corners[i].data()[k] =
          ((m[0] * y.data()[0] + m[4] * y.data()[1]) + m[8] * y.data()[2]) + m[12];
    }
    if (!corners[i].allFinite()) throw InputError("box too far out: a corner overflows");
  }
}

/// Returns what the half extents of the box around the rounded corners lack. Let u = 2^-53, e the
/// largest deviation of the three rotations, S the sum of all half extents, T the largest
/// coordinate of the two centres. A corner rounds by at most 4.1 u (T + 1.01 S) in each coordinate,
/// which moves it by less than 8 u (T + S) along any axis of the new box. A point that law 3 finds
/// in one of the boxes lies within (1.01 e + 9 u) S of it in each of its coordinates (box_frame.cpp
/// derives that), below 1.9 times this along an axis of the new box, whose own law 3 takes as much
/// once more. The deviations are computed with errors below 4 u. All of it is below 2 (e + 32 u) S
/// + 16 u T and some denormals.
double margin(const Obb& box_a, const Obb& box_b, const Obb& fitted) {
  const double deviation = rotation_deviation(box_a.pose) + rotation_deviation(box_b.pose) +
                           rotation_deviation(fitted.pose);
  const double sum =
      box_a.half_extents.sum() + box_b.half_extents.sum() + fitted.half_extents.sum();
  const double farthest = std::max(box_a.pose.translation().cwiseAbs().maxCoeff(),
                                   box_b.pose.translation().cwiseAbs().maxCoeff());
  return 2 * (deviation + 0x1p-48) * sum + 0x1p-49 * farthest + 32 * kLeast;
}

}  // namespace

Obb merged(const Obb& box_a, const Obb& box_b) {
  return bvh::in_standard_arithmetic([&]() -> Obb {
    check_box(box_a, "first box");
    check_box(box_b, "second box");
    std::array<Eigen::Vector3d, 16> corners;
    write_corners(box_a, corners.data());
    write_corners(box_b, corners.data() + 8);
    Obb box = bounding_obb(corners);
    box.half_extents.array() += margin(box_a, box_b, box);
    if (!box.half_extents.allFinite()) {
      throw InputError("boxes too far apart: the box around them overflows");
    }
    return box;
  });
}

}  // namespace graze
