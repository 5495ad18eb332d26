#include "tests/bvh/fit/rational_containment.h"

#include <cmath>

namespace graze::tests {
namespace {

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpq_class dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

RationalPoint difference(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

RationalPoint column(const Pose& pose, int k) {
  return to_rational(pose.matrix().col(k).head<3>());
}

}  // namespace

RationalPoint to_rational(const Eigen::Vector3d& point) {
  return {mpq_class(point.x()), mpq_class(point.y()), mpq_class(point.z())};
}

bool contains(const Aabb& box, const RationalPoint& point) {
  for (int k = 0; k < 3; ++k) {
    if (point[k] < box.min[k] || point[k] > box.max[k]) return false;
  }
  return true;
}

bool contains(const Sphere& sphere, const RationalPoint& point) {
  const RationalPoint offset = difference(point, to_rational(sphere.centre));
  const mpq_class radius(sphere.radius);
  return dot(offset, offset) <= radius * radius;
}

bool contains(const KDop<18>& kdop, const RationalPoint& point) {
  for (int i = 0; i < KDop<18>::kSlabs; ++i) {
    const std::array<int, 3>& d = kKDopDirections<18>[i];
    const mpq_class height = point[0] * d[0] + point[1] * d[1] + point[2] * d[2];
    if (height < kdop.min[i] || height > kdop.max[i]) return false;
  }
  return true;
}

// By Cramer's rule: y_k det = d . (column k+1 x column k+2).
bool contains(const Obb& box, const RationalPoint& point) {
  const RationalPoint d = difference(point, column(box.pose, 3));
  const mpq_class determinant =
      dot(column(box.pose, 0), cross(column(box.pose, 1), column(box.pose, 2)));
  for (int k = 0; k < 3; ++k) {
    const mpq_class y =
        dot(d, cross(column(box.pose, (k + 1) % 3), column(box.pose, (k + 2) % 3))) / determinant;
    if (abs(y) > box.half_extents[k]) return false;
  }
  return true;
}

bool contains_by_law_3(const Obb& box, const Eigen::Vector3d& point) {
  const Eigen::Matrix4d& m = box.pose.matrix();
  const Eigen::Vector3d q = point - box.pose.translation();
  for (int k = 0; k < 3; ++k) {
    const double y = (m(0, k) * q.x() + m(1, k) * q.y()) + m(2, k) * q.z();
    if (!(std::abs(y) <= box.half_extents[k])) return false;
  }
  return true;
}

RationalPoint corner(const Obb& box, const std::array<int, 3>& signs) {
  RationalPoint point = column(box.pose, 3);
  for (int k = 0; k < 3; ++k) {
    const RationalPoint axis = column(box.pose, k);
    for (int i = 0; i < 3; ++i)
      point[i] += axis[i] * mpq_class(box.half_extents[k]) * signs[k];
  }
  return point;
}

}  // namespace graze::tests
