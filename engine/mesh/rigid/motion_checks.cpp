#include <graze/bvh/error.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/mesh/nearest/distance_parts.h>
#include <graze/engine/mesh/placing/placement_check.h>
#include <graze/engine/mesh/rigid/motion_checks.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace graze {
namespace {

// Turning a pose rounds no more than this: an entry of Q - 1 is off by less than 2^-49, and the
// product with three entries of the start rounds less than 2^-51; twice the sum of three of these
// is below it.
constexpr double kRoundingOfTurns = 0x1p-40;

// The squares of lengths that add up to less than this do not overflow.
constexpr double kLongest = 0x1p500;

double sum_of_sizes(const double* v) {
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

}  // namespace

void check_start(const Pose& pose, const char* what) {
  if (bvh::check_rigid(pose, what) <= kMaxRotationDeviation - kRoundingOfTurns) return;
  throw PoseError(std::string(what) + ": so far from a rotation that turning it could go too far");
}

void check_finite(const Eigen::Vector3d& vector, const char* what) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(vector.data()[i]))
      throw InputError(std::string(what) + " of a motion: coordinate " + "xyz"[i] +
                       " is not finite");
  }
}

void check_angle(double angle) {
  if (std::abs(angle) <= kMostTurned) return;
  std::ostringstream message;
  message << "angle of a motion: " << angle << " is not within " << kMostTurned << " radians";
  throw InputError(message.str());
}

Eigen::Vector3d unit_axis(const Eigen::Vector3d& axis) {
  check_finite(axis, "axis");
  const double* a = axis.data();
  const double size = std::max(std::abs(a[0]), std::max(std::abs(a[1]), std::abs(a[2])));
  if (size == 0) throw InputError("axis of a motion: it has no direction");
  // An axis of length 1 but for rounding stays as it is, so that a motion made from the numbers of
  // another is the same. With u = 2^-53: what follows divides by a root that is off by 2.5 u and
  // rounds once more, so that its squares add up to 1 but for 7 u, and their sum is rounded thrice.
  constexpr double kOfLengthOne = 0x1.8p-50;  // 12 u
  if (std::abs(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - 1) <= kOfLengthOne) return axis;
  // The squares neither overflow nor underflow; scaling by a power of two is exact.
  const int exponent = -std::ilogb(size);
  double scaled[3];
  for (int i = 0; i < 3; ++i)
    scaled[i] = std::ldexp(a[i], exponent);
  const double length =
      std::sqrt(scaled[0] * scaled[0] + scaled[1] * scaled[1] + scaled[2] * scaled[2]);
  Eigen::Vector3d unit;
  for (int i = 0; i < 3; ++i)
    unit.data()[i] = scaled[i] / length;
  return unit;
}

const RigidContactSettings& check_settings(const RigidContactSettings& settings) {
  check_clearance(settings.clearance);
  if (settings.tolerance >= 0 && std::isfinite(settings.tolerance)) return settings;
  throw InputError("tolerance: " + bvh::number_text(settings.tolerance) + " is not a distance");
}

double sum_of_lengths(const RigidMotion& motion) {
  const double origin = sum_of_sizes(motion.start().data() + 12);
  const double apart = origin + sum_of_sizes(motion.centre().data());
  return (origin + sum_of_sizes(motion.shift().data())) +
         4 * std::min(std::abs(motion.angle()), 1.0) * apart;
}

void check_coordinates(const RigidMotion& motion) {
  // Where the body does not turn the arm is computed all the same.
  const double centre = sum_of_sizes(motion.centre().data());
  if (sum_of_lengths(motion) + 4 * centre < kFarFromOverflow) return;
  throw PoseError("motion: coordinates of the body's origin could overflow");
}

void check_coordinates(const RigidMotion& motion, const Aabb& bounds, const char* what) {
  if (sum_of_lengths(motion) + sum_of_sizes(bounds) < kLongest) return;
  throw PoseError(std::string(what) +
                  ": coordinates of the body, or squares of them, could overflow");
}

}  // namespace graze
