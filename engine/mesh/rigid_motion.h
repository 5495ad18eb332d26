#pragma once

#include <graze/bvh/pose.h>
#include <Eigen/Core>

namespace graze {

/// The largest angle of a motion, radians: some 160,000 turns.
inline constexpr double kMostTurned = 0x1p20;

/// Says where a body goes while t goes from 0 to 1: its centre goes straight along a shift, and it
/// turns steadily about the centre.
struct RigidCourse {
  /// The point of the body that goes straight, as it is at t = 0, metres in the common frame.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< the way of the centre until t = 1, metres
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< the axis, of any length but 0, in the
                                                    ///< common frame
  double angle = 0;  ///< the turn in radians, right-handed about the axis, at most kMostTurned in
                     ///< size

  bool operator==(const RigidCourse&) const = default;
};

/// Velocities that stay, and for how long.
struct RigidVelocities {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< that of the centre, metres per second
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< radians per second, in the common frame
  /// The point in the body's frame that has the linear velocity, metres: its centre of mass, say.
  Eigen::Vector3d body_centre = Eigen::Vector3d::Zero();
  double duration = 1;  ///< seconds, which t goes through from 0 to 1

  bool operator==(const RigidVelocities&) const = default;
};

/// A turn about a line, and a shift along it.
struct Screw {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< a point of the line, metres in the common
                                                    ///< frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< the direction of the line, of any length
                                                    ///< but 0
  double angle = 0;                                 ///< radians, right-handed about the axis
  double pitch = 0;                                 ///< metres along the axis for each whole turn

  bool operator==(const Screw&) const = default;
};

/// A rigid motion over t from 0 to 1 (law 14): a pose, and a course that it takes. It is a value.
/// Its functions throw PoseError for a pose that is not rigid (law 10, less 2^-40 for what turning
/// rounds) or so far away that a coordinate could overflow, InputError for a zero axis, numbers
/// that are not finite and angles above kMostTurned.
class RigidMotion {
 public:
  /// Lets the body rest in that pose.
  explicit RigidMotion(const Pose& pose) : RigidMotion(pose, RigidCourse{}) {}
  /// Takes the body from a pose along a course.
  RigidMotion(const Pose& start, const RigidCourse& course);

  /// Returns the motion from one pose to another: `body_centre`, a point in the body's frame, goes
  /// straight, and the body turns the short way round, steadily, as slerp has it. Which way it
  /// turns by half a turn is left open. at(1) has the entries of `end` up to 2^-44, and twice the
  /// deviation of both poses from rotations; its translation up to 2^-44 of all lengths that the
  /// motion is made of, and twice the deviation times how far the centre is from the body's origin.
  static RigidMotion between(const Pose& start, const Pose& end,
                             const Eigen::Vector3d& body_centre = Eigen::Vector3d::Zero());

  /// Returns the motion from one pose to another as a screw: along and about one line. Where they
  /// are turned by less than 2^-20 against each other that line is too far away to be known, and
  /// the body's origin goes straight. at(1) is as near to `end` as between()'s, the distance of the
  /// line being one of the lengths.
  static RigidMotion screw_between(const Pose& start, const Pose& end);

  /// Returns the motion from a pose along and about a line, by any number of turns.
  static RigidMotion screw(const Pose& start, const Screw& screw);

  /// Returns the motion from a pose with velocities that stay.
  static RigidMotion from_velocities(const Pose& start, const RigidVelocities& velocities);

  /// Returns the pose at t = 0.
  const Pose& start() const { return start_; }
  /// Returns the centre at t = 0, metres in the common frame.
  const Eigen::Vector3d& centre() const { return centre_; }
  /// Returns the shift of the centre, metres.
  const Eigen::Vector3d& shift() const { return shift_; }
  /// Returns the axis, of length 1 but for 2^-50.
  const Eigen::Vector3d& axis() const { return axis_; }
  /// Returns the angle, radians.
  double angle() const { return angle_; }

  /// Returns the pose at t, from 0 to 1. With Q the rotation by fl(t angle) about the axis, R that
  /// of the start and o its translation, it is Q R and o + t shift + (Q - 1)(o - centre), each
  /// operation rounded in an order that is the same everywhere; no function of a C library but the
  /// root is in it. at(0) is the start to the bit. Throws InputError for another t.
  Pose at(double t) const;

  bool operator==(const RigidMotion& other) const {
    return are_equal(start_, other.start_) && centre_ == other.centre_ && shift_ == other.shift_ &&
           axis_ == other.axis_ && angle_ == other.angle_;
  }

 private:
  Pose start_;
  Eigen::Vector3d centre_;
  Eigen::Vector3d shift_;
  Eigen::Vector3d axis_;
  double angle_;
};

}  // namespace graze
