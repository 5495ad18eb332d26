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

double check_rigid(const Pose& pose, const char* what) {
  const double* m = pose.data();
  bool is_finite = true;
  for (int i = 0; i < 16; ++i)
    is_finite &= m[i] - m[i] == 0;
  for (int i = 0; i < 16 && !is_finite; ++i) {
    if (!std::isfinite(m[i])) {
      throw PoseError(std::string(what) + ": entry (" + std::to_string(i % 4) + ", " +
                      std::to_string(i / 4) + ") is not finite");
    }
  }
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
    throw PoseError(std::string(what) + ": the last row is not (0, 0, 0, 1)");
  }
  const double deviation = rotation_deviation(pose);
  if (!(deviation <= kMaxRotationDeviation)) {
    std::ostringstream message;
    message << what << ": not a rotation, max |R^T R - I| is " << deviation << ", above "
            << kMaxRotationDeviation;
    throw PoseError(message.str());
  }
  // Within the deviation the determinant is close to +1 or -1: its sign needs no care.
  const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) +
                             m[4] * (m[9] * m[2] - m[1] * m[10]) +
                             m[8] * (m[1] * m[6] - m[2] * m[5]);
  if (!(determinant > 0)) {
    throw PoseError(std::string(what) + ": the determinant is negative, this is a reflection");
  }
  return deviation;
}

}  // namespace graze
