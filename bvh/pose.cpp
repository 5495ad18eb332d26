#include <graze/bvh/error.h>
#include <graze/bvh/pose.h>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace graze {

double rotation_deviation(const Pose& pose) {
  const double* m = pose.data();  // column-major 4x4
  double deviation = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const double* u = m + 4 * i;
      const double* v = m + 4 * j;
      const double dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
      deviation = std::max(deviation, std::abs(i == j ? dot - 1 : dot));
    }
  }
  return deviation;
}

namespace {

/// What is wrong with a pose that is not rigid.
[[noreturn]] void throw_not_rigid(const Pose& pose, double deviation, const char* what) {
  const double* m = pose.data();
  for (int i = 0; i < 16; ++i) {
    if (!std::isfinite(m[i])) {
      throw PoseError(std::string(what) + ": entry (" + std::to_string(i % 4) + ", " +
                      std::to_string(i / 4) + ") is not finite");
    }
  }
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
    throw PoseError(std::string(what) + ": the last row is not (0, 0, 0, 1)");
  }
  if (!(deviation <= kMaxRotationDeviation)) {
    std::ostringstream message;
    message << what << ": not a rotation, max |R^T R - I| is " << deviation << ", above "
            << kMaxRotationDeviation;
    throw PoseError(message.str());
  }
  throw PoseError(std::string(what) + ": the determinant is negative, this is a reflection");
}

}  // namespace

double check_rigid(const Pose& pose, const char* what) {
  const double* m = pose.data();
  const double deviation = rotation_deviation(pose);
  // Within the deviation the determinant is close to +1 or -1: its sign needs no care. It is no
  // number if one of its entries is none, and the deviation is infinite if one of them is.
  const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) +
                             m[4] * (m[9] * m[2] - m[1] * m[10]) +
                             m[8] * (m[1] * m[6] - m[2] * m[5]);
  // Each sum is 0 if and only if all of it is: neither infinity nor a number that is none goes
  // away.
  const double last_row = std::abs(m[3]) + std::abs(m[7]) + std::abs(m[11]) + std::abs(m[15] - 1);
  const double infinite = (m[12] - m[12]) + (m[13] - m[13]) + (m[14] - m[14]);
  const bool is_rigid = deviation <= kMaxRotationDeviation && determinant > 0;
  if (!(is_rigid && last_row + infinite == 0)) throw_not_rigid(pose, deviation, what);
  return deviation;
}

}  // namespace graze
