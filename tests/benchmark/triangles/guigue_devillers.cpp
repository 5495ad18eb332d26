#include <algorithm>
#include <cmath>
#include <utility>

#include <tests/benchmark/triangles/guigue_devillers.h>

namespace graze::benchmark {
namespace {

struct Vector {
  double x, y, z;
};

Vector difference(const double* a, const double* b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// ((b - a) x (c - a)) . (d - a)
double volume(const double* a, const double* b, const double* c, const double* d) {
  return dot(cross(difference(b, a), difference(c, a)), difference(d, a));
}

struct Corners {
  const double* p;
  const double* q;
  const double* r;
};

double area(const double* a, const double* b, const double* c, int x, int y) {
  return (b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]);
}

/// Some edge of `s`, which turns counter-clockwise, has all of `t` beyond it.
bool has_separating_edge(const Corners& s, const Corners& t, int x, int y) {
  const double* corner[3] = {s.p, s.q, s.r};
  for (int i = 0; i < 3; ++i) {
    const double* from = corner[i];
    const double* to = corner[(i + 1) % 3];
    if (area(from, to, t.p, x, y) < 0 && area(from, to, t.q, x, y) < 0 &&
        area(from, to, t.r, x, y) < 0) {
      return true;
    }
  }
  return false;
}

bool meet_in_plane(Corners a, Corners b, const Vector& normal) {
  const double size_x = std::abs(normal.x);
  const double size_y = std::abs(normal.y);
  const double size_z = std::abs(normal.z);
  const int axis = size_x > size_y ? (size_x > size_z ? 0 : 2) : (size_y > size_z ? 1 : 2);
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  if (area(a.p, a.q, a.r, x, y) < 0) std::swap(a.q, a.r);
  if (area(b.p, b.q, b.r, x, y) < 0) std::swap(b.q, b.r);
  return !has_separating_edge(a, b, x, y) && !has_separating_edge(b, a, x, y);
}

/// Turns the triangle, keeping its orientation, until the vertex that is alone on its side of the
/// other's plane comes first. True if that vertex is on the negative side. (0, 0, 0) must not be.
bool put_lone_vertex_first(Corners& t, double p, double q, double r) {
  const auto turned_once = [&] { t = {t.q, t.r, t.p}; };
  const auto turned_twice = [&] { t = {t.r, t.p, t.q}; };
  if (p > 0) {
    if (q > 0) return turned_twice(), true;  // r alone, below or in the plane
    if (r > 0) return turned_once(), true;   // q alone
    return false;                            // p alone, above
  }
  if (p < 0) {
    if (q < 0) return turned_twice(), false;
    if (r < 0) return turned_once(), false;
    return true;
  }
  if (q > 0) {
    if (r > 0) return true;
    return turned_once(), false;
  }
  if (q < 0) {
    if (r < 0) return false;
    return turned_once(), true;
  }
  return turned_twice(), r < 0;
}

}  // namespace

bool guigue_devillers(const Triangle& triangle_a, const Triangle& triangle_b) {
  Corners a{triangle_a.a.data(), triangle_a.b.data(), triangle_a.c.data()};
  Corners b{triangle_b.a.data(), triangle_b.b.data(), triangle_b.c.data()};
  const Vector normal_b = cross(difference(b.p, b.r), difference(b.q, b.r));
  const double a_p = dot(normal_b, difference(a.p, b.r));
  const double a_q = dot(normal_b, difference(a.q, b.r));
  const double a_r = dot(normal_b, difference(a.r, b.r));
  if (a_p * a_q > 0 && a_p * a_r > 0) return false;
  const Vector normal_a = cross(difference(a.q, a.p), difference(a.r, a.p));
  const double b_p = dot(normal_a, difference(b.p, a.r));
  const double b_q = dot(normal_a, difference(b.q, a.r));
  const double b_r = dot(normal_a, difference(b.r, a.r));
  if (b_p * b_q > 0 && b_p * b_r > 0) return false;
  if ((a_p == 0 && a_q == 0 && a_r == 0) || (b_p == 0 && b_q == 0 && b_r == 0)) {
    return meet_in_plane(a, b, normal_a);
  }
  const bool is_a_below = put_lone_vertex_first(a, a_p, a_q, a_r);
  const bool is_b_below = put_lone_vertex_first(b, b_p, b_q, b_r);
  if (is_a_below) std::swap(b.q, b.r);
  if (is_b_below) std::swap(a.q, a.r);
  // The paper's interval test, figure 5.
  return volume(a.p, a.q, b.p, b.q) <= 0 && volume(a.p, a.r, b.r, b.p) <= 0;
}

}  // namespace graze::benchmark
