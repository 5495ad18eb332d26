// This makes motions from what users have: two poses, a screw, velocities.

#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/mesh/rigid/sine_cosine.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <cmath>
#include <string>

namespace graze {
namespace {

// The least turn between two poses with a screw. Below it the line of the screw is further away
// than a million times how far the body goes.
constexpr double kLeastTurn = 0x1p-20;

struct Turn {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double angle = 0;  ///< radians, from 0 to pi
};

double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a.x() * b.x() + a.y() * b.y()) + a.z() * b.z();
}

Eigen::Vector3d cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// Returns the turn that takes one rotation to another, by the quaternion of it: of its four
/// components the largest is a root, so that nothing is lost near half a turn.
Turn turn_between(const Pose& start, const Pose& end) {
  double q[3][3];  // this is end start^T
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double *e = end.data() + i, *s = start.data() + j;
      q[i][j] = (e[0] * s[0] + e[4] * s[4]) + e[8] * s[8];
    }
  }
  const double trace = q[0][0] + q[1][1] + q[2][2];
  double w = 1 + trace;
  Eigen::Vector3d v(q[2][1] - q[1][2], q[0][2] - q[2][0], q[1][0] - q[0][1]);
  int i = 0;  // the component whose square is the largest of the three
  for (int k = 1; k < 3; ++k)
    i = q[k][k] > q[i][i] ? k : i;
  if (const double largest = 1 + 2 * q[i][i] - trace; largest > w) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    w = v[i];
    v[i] = largest;
    v[j] = q[i][j] + q[j][i];
    v[k] = q[i][k] + q[k][i];
  }
  if (w < 0) {
    w = -w;
    v = -v;
  }
  const double square = dot(v, v);
  if (square < 0x1p-200) return {};  // there is no turn that a pose could tell
  const double size = std::sqrt(square), length = std::sqrt(square + w * w);
  return {v / size, 2 * angle_of({size / length, w / length})};
}

void check_ends(const Pose& start, const Pose& end) {
  check_start(start, "start of a motion");
  check_start(end, "end of a motion");
}

RigidMotion straight_between(const Pose& start, const Pose& end, const Eigen::Vector3d& centre) {
  const Turn turn = turn_between(start, end);
  const Eigen::Vector3d from = narrowphase::place(start, centre);
  const Eigen::Vector3d to = narrowphase::place(end, centre);
  return {start, {.centre = from, .shift = to - from, .axis = turn.axis, .angle = turn.angle}};
}

}  // namespace

RigidMotion RigidMotion::between(const Pose& start, const Pose& end,
                                 const Eigen::Vector3d& body_centre) {
  return bvh::in_standard_arithmetic([&]() -> RigidMotion {
    check_ends(start, end);
    check_finite(body_centre, "body centre");
    return straight_between(start, end, body_centre);
  });
}

RigidMotion RigidMotion::screw_between(const Pose& start, const Pose& end) {
  return bvh::in_standard_arithmetic([&]() -> RigidMotion {
    check_ends(start, end);
    const Turn turn = turn_between(start, end);
    if (turn.angle < kLeastTurn) return straight_between(start, end, Eigen::Vector3d::Zero());
    // The centre is as far from the middle of both origins as half a chord divided by the tangent
    // of half the angle.
    const Eigen::Vector3d from = start.translation();
    const Eigen::Vector3d displacement = Eigen::Vector3d(end.translation()) - from;
    const Eigen::Vector3d shift = turn.axis * dot(turn.axis, displacement);
    const Eigen::Vector3d chord = displacement - shift;
    const SineCosine half = turn_values(turn.angle / 2).unit;
    const Eigen::Vector3d centre =
        from + (chord + cross(turn.axis, chord) * (half.cosine / half.sine)) / 2;
    return {start, {.centre = centre, .shift = shift, .axis = turn.axis, .angle = turn.angle}};
  });
}

RigidMotion RigidMotion::screw(const Pose& start, const Screw& screw) {
  return bvh::in_standard_arithmetic([&]() -> RigidMotion {
    constexpr double kTurn = 0x1.921fb54442d18p+2;  // 2 pi
    const Eigen::Vector3d shift = unit_axis(screw.axis) * (screw.angle / kTurn * screw.pitch);
    return {start,
            {.centre = screw.point, .shift = shift, .axis = screw.axis, .angle = screw.angle}};
  });
}

RigidMotion RigidMotion::from_velocities(const Pose& start, const RigidVelocities& velocities) {
  return bvh::in_standard_arithmetic([&]() -> RigidMotion {
    check_start(start, "start of a motion");
    check_finite(velocities.linear, "linear velocity");
    check_finite(velocities.angular, "angular velocity");
    check_finite(velocities.body_centre, "body centre");
    if (!(velocities.duration >= 0 && std::isfinite(velocities.duration)))
      throw InputError("duration of a motion: " + bvh::number_text(velocities.duration) +
                       " is not a time");
    const Eigen::Vector3d centre = narrowphase::place(start, velocities.body_centre);
    const Eigen::Vector3d shift = velocities.linear * velocities.duration;
    if (velocities.angular == Eigen::Vector3d::Zero())
      return {start, {.centre = centre, .shift = shift}};
    const Eigen::Vector3d axis = unit_axis(velocities.angular);
    const double speed = dot(axis, velocities.angular);
    return {start,
            {.centre = centre, .shift = shift, .axis = axis, .angle = speed * velocities.duration}};
  });
}

}  // namespace graze
