#include <algorithm>
#include <cmath>

#include <tests/benchmark/triangles/plain_box_test.h>

namespace graze::benchmark {
namespace {

struct Vector {
  double x, y, z;
};

Vector difference(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Vector from(const Eigen::Vector3d& point, const Vector& centre) {
  return {point.data()[0] - centre.x, point.data()[1] - centre.y, point.data()[2] - centre.z};
}

bool is_outside(double a, double b, double c, double half) {
  return std::min(std::min(a, b), c) > half || std::max(std::max(a, b), c) < -half;
}

bool is_outside(double a, double b, double radius) {
  return std::min(a, b) > radius || std::max(a, b) < -radius;
}

/// The axes that are cross products of one edge with the box's; `u` is an end of the edge, `w` the
/// vertex opposite to it.
bool is_separating(const Vector& edge, const Vector& u, const Vector& w, const Vector& half) {
  const Vector size{std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)};
  return is_outside(edge.z * u.y - edge.y * u.z, edge.z * w.y - edge.y * w.z,
                    half.y * size.z + half.z * size.y) ||
         is_outside(edge.x * u.z - edge.z * u.x, edge.x * w.z - edge.z * w.x,
                    half.z * size.x + half.x * size.z) ||
         is_outside(edge.y * u.x - edge.x * u.y, edge.y * w.x - edge.x * w.y,
                    half.x * size.y + half.y * size.x);
}

}  // namespace

bool plain_box_test(const Triangle& triangle, const Aabb& box) {
  const double* low = box.min.data();
  const double* high = box.max.data();
  const Vector centre{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])};
  const Vector half{0.5 * (high[0] - low[0]), 0.5 * (high[1] - low[1]), 0.5 * (high[2] - low[2])};
  const Vector a = from(triangle.a, centre);
  const Vector b = from(triangle.b, centre);
  const Vector c = from(triangle.c, centre);
  if (is_outside(a.x, b.x, c.x, half.x) || is_outside(a.y, b.y, c.y, half.y) ||
      is_outside(a.z, b.z, c.z, half.z)) {
    return false;
  }
  const Vector e = difference(b, a);
  const Vector f = difference(c, b);
  const Vector g = difference(a, c);
  if (is_separating(e, a, c, half) || is_separating(f, b, a, half) ||
      is_separating(g, c, b, half)) {
    return false;
  }
  const Vector n{e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x};
  const double radius = half.x * std::abs(n.x) + half.y * std::abs(n.y) + half.z * std::abs(n.z);
  return std::abs(n.x * a.x + n.y * a.y + n.z * a.z) <= radius;
}

}  // namespace graze::benchmark
