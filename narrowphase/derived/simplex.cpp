#include <graze/narrowphase/derived/simplex.h>
#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

bool are_equal(const double* p, const double* q) {
  return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

/// A point on the line of a segment lies in it if it lies in its box.
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
