#pragma once

#include <array>
#include <optional>
#include <vector>

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>

namespace graze::compare {

/// A closed box in rational numbers: it is a parallelepiped, for the columns of a pose are not
/// quite at right angles.
struct RationalBox {
  RationalPoint centre;
  std::array<RationalPoint, 3>
      columns;                    ///< directions of the edges, also where these have no length
  std::array<mpq_class, 3> half;  ///< half the edges, as shares of the columns
};

RationalBox exactly(const Aabb& box);

/// Returns the points t + R y with |y_i| <= h_i.
RationalBox exactly(const Obb& box);

/// Returns the points with |R^T (p - t)|_i <= h_i, which are not quite the same where R is not
/// quite a rotation.
RationalBox exactly_by_frame(const Obb& box);

/// Returns the box's surface, two triangles a face.
std::vector<RationalTriangle> faces_of(const RationalBox& box);

/// Returns the square of the shortest translation along the normals of the difference after which
/// the two merely touch; nothing if they share no point.
std::optional<mpq_class> squared_overlap(const RationalBox& box_a, const RationalBox& box_b);
std::optional<mpq_class> squared_overlap(const RationalTriangle& triangle, const RationalBox& box);

/// Returns the square of the distance of two that share no point.
mpq_class squared_gap(const RationalBox& box_a, const RationalBox& box_b);
mpq_class squared_gap(const RationalTriangle& triangle, const RationalBox& box);

}  // namespace graze::compare
