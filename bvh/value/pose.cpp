#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/hash.h>
#include <graze/bvh/pose.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/rigid.h>

#include <bit>
#include <cmath>
#include <sstream>
#include <string>

namespace graze {

// Both zeros are equal. Only bits are looked at: the hash does not depend on how the program
// computes.
std::size_t PoseHash::operator()(const Pose& pose) const noexcept {
  std::size_t hash = 0;
  for (int i = 0; i < 16; ++i) {
    const auto bits = std::bit_cast<std::uint64_t>(pose.data()[i]);
    hash = hash_of({hash, bits << 1 == 0 ? 0 : bits});
  }
  return hash;
}

double rotation_deviation(const Pose& pose) {
  return bvh::in_standard_arithmetic(
      [&]() -> double { return bvh::RotationError(pose).largest(); });
}

namespace {

/// Throws an error that says what is wrong with a pose that is not rigid.
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

namespace bvh {

double check_rigid(const Pose& pose, const char* what) {
  const bvh::RotationError error(pose);
  const double* m = pose.data();
  // The sum is 0 if and only if all are finite.
  const double infinite = (m[12] - m[12]) + (m[13] - m[13]) + (m[14] - m[14]);
  if (!(bvh::is_rigid(pose, error) && infinite == 0)) throw_not_rigid(pose, error.largest(), what);
  return error.largest();
}

}  // namespace bvh

double check_rigid(const Pose& pose, const char* what) {
  return bvh::in_standard_arithmetic([&]() -> double { return bvh::check_rigid(pose, what); });
}

}  // namespace graze
