#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/mesh/rigid/sine_cosine.h>
#include <graze/engine/mesh/rigid_motion.h>

#include <cmath>
#include <string>

namespace graze {

RigidMotion::RigidMotion(const Pose& start, const RigidCourse& course)
    : start_(start), centre_(course.centre), shift_(course.shift), angle_(course.angle) {
  bvh::in_standard_arithmetic([&] {
    check_start(start, "start of a motion");
    check_finite(course.centre, "centre");
    check_finite(course.shift, "shift");
    axis_ = unit_axis(course.axis);
    check_angle(course.angle);
    check_coordinates(*this);
  });
}

Pose RigidMotion::at(double t) const {
  return bvh::in_standard_arithmetic([&]() -> Pose {
    if (!(t >= 0 && t <= 1))
      throw InputError("time: " + bvh::number_text(t) + " is not from 0 to 1");
    Pose pose = start_;
    if (angle_ == 0) {
      for (int i = 0; i < 3; ++i)
        pose.data()[12 + i] += t * shift_.data()[i];
      return pose;
    }
    const TurnValues turn = turn_values(t * angle_);
    const double* a = axis_.data();
    const double rest = turn.versine, sine = turn.unit.sine;
    // Q - 1 = rest (a a^T - 1) + sine [a]x.
    const double xy = rest * (a[0] * a[1]), xz = rest * (a[0] * a[2]), yz = rest * (a[1] * a[2]);
    const double x = sine * a[0], y = sine * a[1], z = sine * a[2];
    const double d[3][3] = {{-rest * (a[1] * a[1] + a[2] * a[2]), xy - z, xz + y},
                            {xy + z, -rest * (a[0] * a[0] + a[2] * a[2]), yz - x},
                            {xz - y, yz + x, -rest * (a[0] * a[0] + a[1] * a[1])}};
    const double* m = start_.data();  // column-major 4x4
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        pose.data()[4 * j + i] +=
            (d[i][0] * m[4 * j] + d[i][1] * m[4 * j + 1]) + d[i][2] * m[4 * j + 2];
      }
    }
    double arm[3];
    for (int i = 0; i < 3; ++i)
      arm[i] = m[12 + i] - centre_.data()[i];
    for (int i = 0; i < 3; ++i) {
      pose.data()[12 + i] +=
          t * shift_.data()[i] + ((d[i][0] * arm[0] + d[i][1] * arm[1]) + d[i][2] * arm[2]);
    }
    return pose;
  });
}

}  // namespace graze
