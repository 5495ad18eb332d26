#include <graze/narrowphase/convex/box_axes.h>
#include <graze/narrowphase/convex/segments.h>

#include <initializer_list>
#include <limits>

namespace graze::narrowphase {
namespace {

// Edges at a smaller angle than about this give no axis of their own: faces do as well there.
constexpr double kParallel = 1e-6;
constexpr double kEdgeGain = 0.95;

/// Two boxes in the frame of A: what the lengths along all axes are made of. Axes are at right
/// angles and of length 1 as far as poses are rotations: near enough to compare by.
struct BoxesInA {
  BoxesInA(const Core& box_a, const Core& box_b)
      : half_a{box_a.half.x, box_a.half.y, box_a.half.z},
        half_b{box_b.half.x, box_b.half.y, box_b.half.z} {
    const Vec3 between = box_b.at - box_a.at;
    for (int i = 0; i < 3; ++i) {
      way_a[i] = dot(box_a.axis[i], between);
      way_b[i] = dot(box_b.axis[i], between);
      for (int j = 0; j < 3; ++j) {
        turn[i][j] = dot(box_a.axis[i], box_b.axis[j]);
        size[i][j] = std::abs(turn[i][j]);
      }
    }
  }

  double past_face_a(int i) const {
    return half_a[i] +
           ((half_b[0] * size[i][0] + half_b[1] * size[i][1]) + half_b[2] * size[i][2]) -
           std::abs(way_a[i]);
  }
  double past_face_b(int j) const {
    return half_b[j] +
           ((half_a[0] * size[0][j] + half_a[1] * size[1][j]) + half_a[2] * size[2][j]) -
           std::abs(way_b[j]);
  }
  /// Along the product of two axes, which is as long as the square root of square_of().
  double past_edges(int i, int j) const {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return (half_a[i1] * size[i2][j] + half_a[i2] * size[i1][j]) +
           (half_b[j1] * size[i][j2] + half_b[j2] * size[i][j1]) - std::abs(way_along(i, j));
  }
  double square_of(int i, int j) const {
    const double u = turn[(i + 1) % 3][j], v = turn[(i + 2) % 3][j];
    return u * u + v * v;
  }
  double way_along(int i, int j) const {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    return turn[i1][j] * way_a[i2] - turn[i2][j] * way_a[i1];
  }

  double half_a[3], half_b[3], way_a[3], way_b[3], turn[3][3], size[3][3];
};

}  // namespace

Penetration least_axis(const Core& box_a, const Core& box_b) {
  const BoxesInA boxes(box_a, box_b);
  Vec3 best;
  double depth = std::numeric_limits<double>::infinity();
  const auto offer_face = [&](double found, const Vec3& axis, double way) {
    if (!(found < depth)) return;
    depth = found;
    best = way < 0 ? -axis : axis;
  };
  for (int i = 0; i < 3; ++i)
    offer_face(boxes.past_face_a(i), box_a.axis[i], boxes.way_a[i]);
  for (int j = 0; j < 3; ++j)
    offer_face(boxes.past_face_b(j), box_b.axis[j], boxes.way_b[j]);
  int edge_a = -1, edge_b = -1;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double square = boxes.square_of(i, j);
      if (!(square > kParallel * kParallel)) continue;
      const double found = boxes.past_edges(i, j);
      const double wanted = kEdgeGain * depth;
      if (found > 0 && wanted > 0 && found * found >= (wanted * wanted) * square) continue;
      const double of_unit = found / std::sqrt(square);
      if (!(of_unit < wanted)) continue;
      depth = of_unit;
      edge_a = i, edge_b = j;
    }
  }
  if (edge_a >= 0) {
    const Vec3 product = cross(box_a.axis[edge_a], box_b.axis[edge_b]);
    best = boxes.way_along(edge_a, edge_b) < 0 ? -product : product;
  }
  best = unit_or(best, {0, 0, 1});
  Penetration way = along(box_a, box_b, best);
  if (edge_a < 0) return way;
  const BoxEdge of_a = edge_along(box_a, edge_a, best);
  const BoxEdge of_b = edge_along(box_b, edge_b, -best);
  const NearestPoints met = nearest_of_segments(of_a.from, of_a.to, of_b.from, of_b.to);
  way.point_a = met.point_a;
  way.point_b = met.point_b;
  way.has_witnesses = true;
  return way;
}

BoxEdge edge_along(const Core& box, int axis, const Vec3& direction) {
  const double half[3] = {box.half.x, box.half.y, box.half.z};
  Vec3 middle = box.at;
  for (int k = 0; k < 3; ++k) {
    if (k == axis) continue;
    middle = middle + box.axis[k] * (dot(box.axis[k], direction) < 0 ? -half[k] : half[k]);
  }
  const Vec3 reach = box.axis[axis] * half[axis];
  return {middle - reach, middle + reach};
}

Penetration nearest_face(const Core& box, const Core& point) {
  Penetration best{};
  bool is_first = true;
  for (const Vec3& axis : box.axis) {
    for (const double sign : {1.0, -1.0}) {
      const Penetration found = along(box, point, unit_or(axis * sign, {0, 0, 1}));
      if (is_first || found.depth < best.depth) best = found;
      is_first = false;
    }
  }
  return best;
}

}  // namespace graze::narrowphase
