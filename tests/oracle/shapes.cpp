#include <tests/oracle/shapes.h>

namespace graze::oracle {

using Eigen::Vector3d;

Triangle moved(const Triangle& t, const Vector3d& by) {
  return for_each_vertex(t, [&](const Vector3d& p) { return Vector3d(p + by); });
}

TrianglePair moved(const TrianglePair& pair, const Vector3d& by) {
  return {moved(pair.a, by), moved(pair.b, by)};
}

TriangleAndBox moved(const TriangleAndBox& pair, const Vector3d& by) {
  return {moved(pair.triangle, by), {pair.box.min + by, pair.box.max + by}};
}

Triangle scaled(const Triangle& t, double factor) {
  return for_each_vertex(t, [&](const Vector3d& p) { return Vector3d(p * factor); });
}

TrianglePair scaled(const TrianglePair& pair, double factor) {
  return {scaled(pair.a, factor), scaled(pair.b, factor)};
}

TriangleAndBox scaled(const TriangleAndBox& pair, double factor) {
  return {scaled(pair.triangle, factor), {pair.box.min * factor, pair.box.max * factor}};
}

Vector3d turned(const Vector3d& p, int turns) {
  Vector3d result;
  for (int i = 0; i < 3; ++i)
    result[(i + turns) % 3] = p[i];
  return result;
}

Triangle turned(const Triangle& t, int turns) {
  return for_each_vertex(t, [&](const Vector3d& p) { return turned(p, turns); });
}

TrianglePair turned(const TrianglePair& pair, int turns) {
  return {turned(pair.a, turns), turned(pair.b, turns)};
}

TriangleAndBox turned(const TriangleAndBox& pair, int turns) {
  return {turned(pair.triangle, turns), {turned(pair.box.min, turns), turned(pair.box.max, turns)}};
}

Vector3d point_at(const Triangle& t, double weight_b, double weight_c) {
  return t.a + weight_b * (t.b - t.a) + weight_c * (t.c - t.a);
}

Aabb box_between(const Vector3d& p, const Vector3d& q) {
  return {p.cwiseMin(q), p.cwiseMax(q)};
}

std::array<Vector3d, 8> corners(const Aabb& box) {
  std::array<Vector3d, 8> result;
  for (int k = 0; k < 8; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      result[k][axis] = (k >> axis & 1) != 0 ? box.max[axis] : box.min[axis];
    }
  }
  return result;
}

}  // namespace graze::oracle
