#include "tests/engine/hulls/hull_sets.h"

#include <Eigen/Geometry>
#include <cmath>

namespace graze::tests {

using Eigen::Vector3d;

namespace {

std::vector<Vector3d> cube() {
  std::vector<Vector3d> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  return points;
}

Vector3d on_ball(RandomSource& source) {
  for (;;) {
    const Vector3d p = source.vector(-1, 1);
    if (p.norm() > 0.1 && p.norm() <= 1) return p.normalized();
  }
}

}  // namespace

std::vector<Vector3d> hull_points(HullSet set, double t, RandomSource& source) {
  const int count = static_cast<int>(source.integer(4, 11));
  std::vector<Vector3d> points;
  switch (set) {
    case HullSet::RaisedCentre:
      points = cube();
      points.emplace_back(0, 0, 1 + t);
      return points;
    case HullSet::Dome:
      for (int i = 0; i < 9; ++i) {
        const double x = i % 3 - 1, y = i / 3 - 1;
        points.emplace_back(x, y, -t * (x * x + y * y));
      }
      points.emplace_back(0, 0, -1);
      return points;
    case HullSet::ShakenBox:
      points = cube();
      for (int i = 0; i < 3; ++i)
        points.emplace_back(source.uniform(-1, 1), 1, 1);
      for (Vector3d& p : points)
        p += source.vector(-t, t);
      return points;
    case HullSet::Wedge:
      return {{0, -1, 0}, {0, 1, 0}, {1, 1, t}, {1, -1, t}, {1, 1, -t}, {1, -1, -t}};
    default:
      break;
  }
  for (int i = 0; i < count; ++i) {
    switch (set) {
      case HullSet::FlatBall:
        points.push_back(on_ball(source).cwiseProduct(Vector3d(1, 1, t)));
        break;
      case HullSet::Lattice:
        points.push_back(source.lattice_point(-1, 1).cwiseProduct(Vector3d(1, 1, t)));
        break;
      case HullSet::Needle:
        points.push_back(source.vector(-1, 1).cwiseProduct(Vector3d(1, t, t)));
        break;
      default:
        points.push_back(source.vector(-1, 1).cwiseProduct(Vector3d(1, 1, t)));
    }
  }
  return points;
}

double random_thinness(RandomSource& source) {
  const double least = source.integer(0, 15) == 0 ? -200 : -16;
  return std::pow(10.0, source.uniform(least, 0));
}

void turn(std::vector<Vector3d>& points, RandomSource& source) {
  const Vector3d axis = on_ball(source);
  const Eigen::Matrix3d matrix = Eigen::AngleAxisd(source.uniform(0, 3.1), axis).toRotationMatrix();
  for (Vector3d& p : points)
    p = matrix * p;
}

void move(std::vector<Vector3d>& points, double scale, const Vector3d& shift) {
  for (Vector3d& p : points)
    p = p * scale + shift;
}

}  // namespace graze::tests
