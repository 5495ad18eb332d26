#include <graze/narrowphase/derived/simplex.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace graze::narrowphase {
namespace {

using Corner = std::array<double, 3>;
using CornerList = std::array<Corner, 3>;

bool is_before(const Corner& p, const Corner& q) {
  if (p[0] != q[0]) return p[0] < q[0];
  if (p[1] != q[1]) return p[1] < q[1];
  return p[2] < q[2];
}

/// Adding zero turns -0 into 0, so that corners that compare equal are equal bit for bit.
Corner corner_of(const Eigen::Vector3d& p) {
  return {p.data()[0] + 0.0, p.data()[1] + 0.0, p.data()[2] + 0.0};
}

CornerList sorted_corners(const Triangle& triangle) {
  CornerList corners{corner_of(triangle.a), corner_of(triangle.b), corner_of(triangle.c)};
  if (is_before(corners[1], corners[0])) std::swap(corners[0], corners[1]);
  if (is_before(corners[2], corners[1])) std::swap(corners[1], corners[2]);
  if (is_before(corners[1], corners[0])) std::swap(corners[0], corners[1]);
  return corners;
}

bool is_before(const CornerList& s, const CornerList& t) {
  for (int i = 0; i < 3; ++i) {
    if (s[i] != t[i]) return is_before(s[i], t[i]);
  }
  return false;
}

void copy(const CornerList& from, double (&to)[3][3]) {
  for (int i = 0; i < 3; ++i)
    std::copy(from[i].begin(), from[i].end(), to[i]);
}

bool are_equal(const double* p, const double* q) {
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/// True if a point on the line of a segment lies in it, which it does if it lies in its box.
bool is_on_segment(const double* point, const double* from, const double* to) {
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] < std::min(from[axis], to[axis])) return false;
    if (point[axis] > std::max(from[axis], to[axis])) return false;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Sign turn = orientation_2d(project(from, axis), project(to, axis), project(point, axis));
    if (turn != Sign::Zero) return false;
  }
  return true;
}

}  // namespace

OrderedTriangles ordered(const Triangle& triangle_a, const Triangle& triangle_b) {
  const CornerList a = sorted_corners(triangle_a);
  const CornerList b = sorted_corners(triangle_b);
  OrderedTriangles result;
  result.is_swapped = is_before(b, a);
  copy(result.is_swapped ? b : a, result.a);
  copy(result.is_swapped ? a : b, result.b);
  return result;
}

Simplex::Simplex(const double (&corners)[3][3]) : corner_{corners[0], corners[1], corners[2]} {
  double best_area = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 a = project(corner_[0], axis);
    const Point2 b = project(corner_[1], axis);
    const Point2 c = project(corner_[2], axis);
    const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    if (axis_ >= 0 && !(area > best_area)) continue;
    const Sign turn = orientation_2d(a, b, c);
    if (turn == Sign::Zero) continue;
    axis_ = axis;
    turn_ = turn;
    best_area = area;
  }
  is_point_ = are_equal(corner_[0], corner_[2]);
}

Location locate(const double* point, const Simplex& simplex, Sign side) {
  if (simplex.is_point()) return {are_equal(point, simplex.vertex(0)), 0b110};
  if (!simplex.has_area()) {
    if (are_equal(point, simplex.vertex(0))) return {true, edges_at_vertex(0)};
    if (are_equal(point, simplex.vertex(2))) return {true, edges_at_vertex(2)};
    return {is_on_segment(point, simplex.vertex(0), simplex.vertex(2)), 0b100};
  }
  if (side != Sign::Zero) return {false, 0};
  const int axis = simplex.axis();
  unsigned edges = 0;
  for (int edge = 0; edge < 3; ++edge) {
    const Point2 from = project(simplex.vertex(edge), axis);
    const Point2 to = project(simplex.vertex((edge + 1) % 3), axis);
    const Sign turn = orientation_2d(from, to, project(point, axis));
    if (turn == -simplex.turn()) return {false, 0};
    if (turn == Sign::Zero) edges |= 1u << edge;
  }
  return {true, edges};
}

}  // namespace graze::narrowphase
