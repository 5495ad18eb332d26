#include "samples/simulation/integrator.h"

#include <Eigen/LU>

namespace graze::samples {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void advance(RigidBody& body, double seconds) {
  body.at += seconds * body.velocity;
  const double angle = seconds * body.spin.norm();
  if (angle == 0) return;
  const Eigen::Quaterniond by(Eigen::AngleAxisd(angle, body.spin.normalized()));
  body.turn = (by * body.turn).normalized();
}

void precess(RigidBody& body, double seconds) {
  const Matrix3d& inertia = body.mass->inertia;
  const Vector3d spin = body.turn.conjugate() * body.spin;  // the spin in the body's frame
  const auto crossing = [](const Vector3d& v) {
    Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
  };
  const Vector3d momentum = inertia * spin;
  const Vector3d rest = seconds * spin.cross(momentum);
  const Matrix3d slope = inertia + seconds * (crossing(spin) * inertia - crossing(momentum));
  body.spin = body.turn * (spin - slope.inverse() * rest);
}

}  // namespace graze::samples
