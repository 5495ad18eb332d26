#include <graze/narrowphase/derived/ordered_triangles.h>
#include <algorithm>
#include <array>

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

}  // namespace graze::narrowphase
