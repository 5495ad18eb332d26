#include "data/generator/dice.h"

#include <cmath>

#include "data/generator/hash.h"

namespace graze::generator {

double Dice::uniform(double low, double high) {
  return low + (high - low) * unit_interval(hash({seed_, drawn_++}));
}

Eigen::Vector3d Dice::vector(const Eigen::Vector3d& reach) {
  const double x = uniform(-reach.x(), reach.x());
  const double y = uniform(-reach.y(), reach.y());
  return {x, y, uniform(-reach.z(), reach.z())};
}

// A point of the cube that lies in the ball, but not near its middle, whose direction is rounded
// badly.
Eigen::Vector3d Dice::direction() {
  while (true) {
    const Eigen::Vector3d v = vector({1, 1, 1});
    const double squared = squared_length(v);
    if (squared > 0.01 && squared < 1) return v / std::sqrt(squared);
  }
}

Eigen::Matrix3d Dice::rotation() {
  while (true) {
    const Eigen::Vector3d xyz = vector({1, 1, 1});
    const double w = uniform(-1, 1);
    const double squared = squared_length(xyz) + w * w;
    if (squared > 0.01 && squared < 1) return quaternion_rotation(w, xyz);
  }
}

Eigen::Matrix3d quaternion_rotation(double w, const Eigen::Vector3d& xyz) {
  const double length = std::sqrt(squared_length(xyz) + w * w);
  const double r = w / length;
  const double x = xyz.x() / length;
  const double y = xyz.y() / length;
  const double z = xyz.z() / length;
  Eigen::Matrix3d result;
  result << 1 - 2 * (y * y + z * z), 2 * (x * y - r * z), 2 * (x * z + r * y),  //
      2 * (x * y + r * z), 1 - 2 * (x * x + z * z), 2 * (y * z - r * x),        //
      2 * (x * z - r * y), 2 * (y * z + r * x), 1 - 2 * (x * x + y * y);
  return result;
}

double squared_length(const Eigen::Vector3d& v) {
  return v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
}

}  // namespace graze::generator
