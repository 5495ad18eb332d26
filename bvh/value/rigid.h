#pragma once

// This is private to graze: what the door asks of a pose, inline, because each query pays for it.

#include <graze/bvh/pose.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace graze::bvh {

/// The entries of R^T R - I of a pose, each once.
class RotationError {
 public:
  explicit RotationError(const Pose& pose) {
    const double* m = pose.data();  // column-major 4x4
    const Two x_y[3] = {Two::Map(m), Two::Map(m + 4), Two::Map(m + 8)};
    const double z[3] = {m[2], m[6], m[10]};
    // Returns the dot products of columns i and j, and of k and l. A dot product adds from left to
    // right.
    const auto dots = [&](int i, int j, int k, int l) {
      const Two one = x_y[i] * x_y[j];
      const Two other = x_y[k] * x_y[l];
      return Two(Two(one.x(), other.x()) + Two(one.y(), other.y()) +
                 Two(z[i], z[k]) * Two(z[j], z[l]));
    };
    entries_[0] = (dots(0, 0, 1, 1) - Two(1, 1)).abs();
    entries_[1] = (dots(2, 2, 0, 1) - Two(1, 0)).abs();
    entries_[2] = dots(0, 2, 1, 2).abs();
  }

  double largest() const {
    const Two most = entries_[0].max(entries_[1]).max(entries_[2]);
    return std::max(most.x(), most.y());
  }

  /// True if no entry is above `most`. It is never true of what is no number, which a maximum may
  /// lose and a sum does not.
  bool is_within(double most) const {
    const Two sums = entries_[0] + entries_[1] + entries_[2];
    const double sum = sums.x() + sums.y();
    return sum <= most || (sum <= 7 * most && largest() <= most);
  }

 private:
  using Two = Eigen::Array2d;  ///< most processors have registers for two doubles
  std::array<Two, 3> entries_;
};

/// True if a pose turns and does not mirror, provided that its columns are nearly unit vectors at
/// right angles: then the determinant is close to +1 or -1, and its sign needs no care.
inline bool is_right_handed(const Pose& pose) {
  const double* m = pose.data();
  return m[0] * (m[5] * m[10] - m[6] * m[9]) + m[4] * (m[9] * m[2] - m[1] * m[10]) +
             m[8] * (m[1] * m[6] - m[2] * m[5]) >
         0;
}

/// True if the last row is (0, 0, 0, 1).
inline bool has_last_row(const Pose& pose) {
  const double* m = pose.data();
  // The sum is 0 if and only if each is: neither infinity nor what is no number goes away.
  return std::abs(m[3]) + std::abs(m[7]) + std::abs(m[11]) + std::abs(m[15] - 1) == 0;
}

/// True if check_rigid() lets a pose in whose translation is finite and whose rotation is off by
/// `error`.
inline bool is_rigid(const Pose& pose, const RotationError& error) {
  return error.is_within(kMaxRotationDeviation) && is_right_handed(pose) && has_last_row(pose);
}

}  // namespace graze::bvh
