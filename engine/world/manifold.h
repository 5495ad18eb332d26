#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

#include <graze/bvh/hash.h>
#include <graze/engine/world/shape_pairs.h>

namespace graze {

/// Which parts of two shapes meet in a contact: corners, edges and faces by numbers of the shape's
/// own, the same in every pose. Where the same parts meet in the next step, the feature is the
/// same, so that a solver can start from what it found before. Unique within a manifold.
struct ContactFeature {
  std::uint64_t a;  ///< of A, by a number of its own
  std::uint64_t b;  ///< of B
  auto operator<=>(const ContactFeature&) const = default;
};

/// One point in which two shapes meet.
struct ShapeContact {
  Eigen::Vector3d point;    ///< midway between point_a and point_b, metres, in the world's frame
  Eigen::Vector3d point_a;  ///< on A's surface
  Eigen::Vector3d point_b;  ///< on B's
  Eigen::Vector3d normal;   ///< unit, from A to B
  double depth;             ///< metres, >= 0: how far the two reach past each other here
  ContactFeature feature;   ///< which parts of the two meet here

  bool operator==(const ShapeContact&) const = default;
};

/// Up to four contacts that stand for all of a pair, the deepest first.
struct Manifold {
  std::array<ShapeContact, 4> contacts;  ///< the first `count`
  std::size_t count = 0;                 ///< at most 4

  std::size_t size() const { return count; }
  bool empty() const { return count == 0; }
  auto begin() const { return contacts.begin(); }
  auto end() const { return contacts.begin() + static_cast<std::ptrdiff_t>(count); }
  const ShapeContact& operator[](std::size_t index) const { return contacts[index]; }

  /// Of the contacts that there are.
  bool operator==(const Manifold& other) const {
    return std::equal(begin(), end(), other.begin(), other.end());
  }
};

/// Where two placed shapes meet; empty exactly when intersects() is false.
///
/// **Convex shapes.** All contacts share one normal. Let the tolerance be 1e-6 of the smaller size
/// and kTouchTolerance of the scale (shape_pairs.h). By how much the two reach past each other
/// along the normal is the least over all directions to that tolerance: proved, unless
/// Work::penetration_failures counts the pair; then it parts the two, and how near it is to the
/// least nobody knows. Of two boxes the least is 19 twentieths of it at least, but for the
/// tolerance, as a face is taken where two edges would be nearer by less. For poses that are no
/// rotations to more than rounding, add by how much they deviate, of the scale. The greatest depth
/// of the contacts is that width, to the tolerance or 1e-4 of how far the contacts are spread,
/// whichever is more: moving B by as much along the normal parts them. So a motion by d changes
/// that width by at most d and the tolerance. A cylinder's cap and a cone's base count as octagons.
///
/// **Meshes** are one-sided: their triangles turn counter-clockwise as seen from outside. With a
/// convex shape each triangle that it meets offers contacts: along the triangle's normal, if the
/// shape's middle is outside its plane and the common area is not empty, else along the shortest
/// separating translation. Triangles that the middle is behind count only if there are no others.
/// Two meshes offer the corners of the patches in which they meet, points of the curves of their
/// find_intersection(): each with its patch's normal, that of the area which its curves enclose,
/// and the depth of the closed curve that it lies on. A patch that lies in several curves, as where
/// the teeth of a comb enter, offers a point of the deepest one, too: so the first contact is as
/// deep as any. A depth is mostly find_contacts()'s, and a guide: it is not proved to part them.
/// Curves that do not close, of open meshes or where rounding tears them, count together as far as
/// triangles connect them; and of a part inside with thousands of vertices those are looked at to
/// which the way in leads, up to 96 for all curves, or 8 for each. Meshes that only touch, in a
/// plane, along a line or in a point, offer their find_contacts().
///
/// **Points.** Each point_a is on A's surface and each point_b on B's, however deep the two are, to
/// 2^-32 of the scale of the pair (their sizes and the distance of their middles) and the rounding
/// of world coordinates. Unless both are meshes, point_a - point_b is depth times normal: along the
/// normal A ends at point_a, depth beyond point_b, where B begins. Where faces, or edges that lie
/// along each other, meet, and above a half-space that holds to the same tolerance. Where one point
/// of each meets, the two are where the shapes touch once they are parted: to 2^-17 of the smaller
/// one's size, or 2^-16 of the scale if one is a sphere or a capsule; and no better than the depth
/// is the least, which of a box and a box or a mesh is to a twentieth of it, and nothing if
/// Work::penetration_failures counts the pair. Two meshes go through each other at their contacts:
/// point_a and point_b are one point, on both surfaces, and the depth is that of the curve.
///
/// Of all that is offered four remain: the deepest, and those that are far from all that remain. So
/// that features persist, edges of two faces that are within a 256th of the smaller shape's size of
/// each other count as one, which no answer of yes or no depends on: where such an edge ends the
/// common area, its corners slide along their face onto that end, and keep their names.
/// Swapping A and B mirrors the result, bit for bit: normals turn round, and features change
/// places. Of equal shapes in equal poses there is nothing to mirror, as the swapped question is
/// the same one: then the result is the same, too. Throws as intersects() does, and
/// UnsupportedPairError for two half-spaces that intersect: no finite translation parts them.
///
/// Of two meshes `find_contacts({bolt}, {nut, pose})` is that of mesh_contacts.h: say
/// `{Shape(bolt)}` where a manifold is meant.
template <typename = void>
Manifold find_contacts(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                       Work* work = nullptr);

}  // namespace graze

template <>
struct std::hash<graze::ContactFeature> {
  std::size_t operator()(const graze::ContactFeature& feature) const noexcept {
    return graze::hash_of({feature.a, feature.b});
  }
};
