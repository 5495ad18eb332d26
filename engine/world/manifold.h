#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>

#include <graze/bvh/hash.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/sides.h>

namespace graze {

/// Which parts of two shapes meet in a contact: corners, edges and faces by numbers of the shape's
/// own, the same in every pose. Where the same parts meet in the next step, the feature is the
/// same, so that a solver can start from what it found before; which contacts go on a
/// ContactTracker says (contact_tracker.h). Unique within a manifold.
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
  double depth;             ///< metres: how far the two reach past each other here; negative only
                            ///< where a margin was asked for: minus how far they are apart
  ContactFeature feature;   ///< which parts of the two meet here
  std::uint32_t region;     ///< contacts of one region share a way out; see Manifold
  /// What A is made of there: the material of the triangle of a mesh, or of the cell of a height
  /// field, that is nearest to point_a, of several that of the least number. 0 of what has none.
  /// How two go together is the user's to say.
  std::uint16_t material_a;
  std::uint16_t material_b;  ///< of B at point_b, likewise

  bool operator==(const ShapeContact&) const = default;
};

/// The contacts of a pair, region by region: of each at most four that stand for all of it, its
/// deepest first; and the region with the deepest first. Where two bodies meet in several regions,
/// as a plank that lies on two trestles or a box in a corner, each has its own normal. Two convex
/// bodies meet in one. Four contacts take no memory beyond the manifold's own.
class Manifold {
 public:
  static constexpr std::size_t kMostOfRegion = 4;  ///< contacts of one region

  Manifold() = default;
  /// Takes over what memory there is, and leaves `other` with valid contacts that nobody knows.
  Manifold(Manifold&& other) noexcept { *this = std::move(other); }
  Manifold& operator=(Manifold&& other) noexcept;
  /// Copies the contacts that there are, mostly one or two of four.
  Manifold(const Manifold& other) { *this = other; }
  Manifold& operator=(const Manifold& other);

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const ShapeContact* begin() const { return data(); }
  const ShapeContact* end() const { return data() + count_; }
  const ShapeContact& operator[](std::size_t index) const { return data()[index]; }
  /// To be changed in place.
  ShapeContact& operator[](std::size_t index) { return data()[index]; }

  /// How many regions there are, and the contacts of one.
  std::size_t region_count() const { return count_ == 0 ? 0 : (*this)[count_ - 1].region + 1; }
  std::span<const ShapeContact> region(std::size_t index) const;

  /// Which part of A and of B it is about, if they are compounds in a world; else 0.
  std::uint32_t part_a() const { return part_a_; }
  std::uint32_t part_b() const { return part_b_; }
  void set_parts(std::uint32_t of_a, std::uint32_t of_b) { part_a_ = of_a, part_b_ = of_b; }

  void clear() { count_ = 0; }
  /// Adds a contact of the last region, or of the next; there may be more than four.
  void add(const ShapeContact& contact);

  bool operator==(const Manifold& other) const {
    return part_a_ == other.part_a_ && part_b_ == other.part_b_ &&
           std::equal(begin(), end(), other.begin(), other.end());
  }

 private:
  const ShapeContact* data() const { return count_ <= kMostOfRegion ? few_.data() : all_.get(); }
  ShapeContact* data() { return count_ <= kMostOfRegion ? few_.data() : all_.get(); }
  void make_room(std::size_t count);

  std::uint32_t part_a_ = 0, part_b_ = 0;
  std::size_t count_ = 0;
  std::size_t capacity_ = 0;                     ///< of all_
  std::unique_ptr<ShapeContact[]> all_;          ///< if there are more than four
  std::array<ShapeContact, kMostOfRegion> few_;  ///< else
};

inline Manifold& Manifold::operator=(const Manifold& other) {
  if (other.count_ > kMostOfRegion) make_room(other.count_);
  count_ = other.count_;
  set_parts(other.part_a_, other.part_b_);
  std::copy(other.begin(), other.end(), data());
  return *this;
}

inline Manifold& Manifold::operator=(Manifold&& other) noexcept {
  std::swap(capacity_, other.capacity_);
  all_.swap(other.all_);
  count_ = std::exchange(other.count_, 0);
  set_parts(other.part_a_, other.part_b_);
  if (count_ <= kMostOfRegion) std::copy_n(other.few_.begin(), count_, few_.begin());
  return *this;
}

/// Where two placed shapes meet, as a solver asks; empty exactly when intersects() is false.
///
/// **Convex shapes.** All contacts share one normal. Let the tolerance be 1e-6 of the smaller size
/// and kTouchTolerance of the scale (shape_pairs.h). By how much the two reach past each other
/// along the normal is the least over all directions to that tolerance: proved, unless
/// Work::penetration_failures counts the pair; then it parts the two, and how near it is to the
/// least nobody knows. Of two boxes the least is 19 twentieths of it at least, but for the
/// tolerance, as a face is taken where two edges would be nearer by less. For poses that are no
/// rotations to more than rounding, add by how much they deviate, of the scale. The greatest depth
/// of the contacts is that width, to the tolerance, and to a thousandth of what parts the two along
/// the normal. So a motion by d changes that width by at most d and the tolerance. A cylinder's cap
/// and a cone's base count as octagons, but not for how deep they are.
///
/// **Meshes** are one-sided: their triangles turn counter-clockwise as seen from outside, and what
/// is behind a surface leaves it in front. Law 15 (narrowphase/README.md) says what a region is and
/// which way leads out of it: a direction that a face, a convex edge or a corner of a mesh faces.
/// So a polyhedron has the same contacts as the closed mesh of its surface, however that is
/// tessellated: the greatest depth to a twentieth, its normal to a degree or one that parts the two
/// as well, while the depth is at most a tenth of the smaller body. Edges between triangles of one
/// plane have no effect. Each contact has its own depth: what leans is deepest where it leans.
/// Regions between walls that are too near to each other to satisfy both are all listed. Where
/// nothing but triangles of no height is touched, each parts from a shape along the shortest way.
/// Where the deepest point lies beyond the triangles that are touched, as in a valley, a region's
/// contact is less deep than its way out. Of two meshes curves that do not close, where a mesh is
/// open or where rounding tears them, count as one piece as far as triangles connect them. A piece
/// that wraps around, as that of a nut on a bolt, has a region for each triangle that it has to be
/// left by. Meshes
/// that only touch, in a plane, along a line or in a point, offer their find_contacts().
///
/// **Points.** Each point_a is on A's surface and each point_b on B's, however deep the two are, to
/// 2^-32 of the scale of the pair (their sizes and the distance of their middles) and the rounding
/// of world coordinates. point_a - point_b is depth times normal, where faces, or edges along each
/// other, meet, and above a half-space, to the same tolerance. Where one point of each meets, the
/// two are where the shapes touch once they are parted: to 2^-17 of the smaller one's size and
/// 2^-30 of the scale, or 2^-16 of the scale if one is a sphere or a capsule; and no better than
/// the depth is the least, which of a box and a box or a mesh is to a twentieth of it, and nothing
/// if Work::penetration_failures counts the pair. Of two meshes, up to the depths of law 15, one of
/// the points is on its surface, to 1e-9 of the scale; the other as near to the plane of a face
/// there, or across the normal where a corner or an edge is left: beside its surface where that is
/// curved, and where faces lie in each other but for rounding as far as the first body reaches.
/// Deeper, and of a hit that a search left open (PairStatus::NotConverged), no surface is promised.
///
/// Of all that a region offers four remain: the deepest, and those that are far from all that
/// remain. Where all are nearly as deep, as of what lies, their places alone say which; then one of
/// them moves within the region to where it is deep enough, and keeps its feature, so that its
/// point may be beside the corner that it is called after. So that features persist, edges of two
/// faces that are within a 256th of the smaller shape's size of each other count as one, which no
/// answer of yes or no depends on: where such an edge ends the common area, its corners slide along
/// their face onto that end, and keep their names. Swapping A and B mirrors the result, bit for
/// bit: normals turn round, and features change places. Of equal shapes in equal poses there is
/// nothing to mirror, as the swapped question is the same one: then the result is the same, too.
/// Throws as intersects() does, and UnsupportedPairError for two half-spaces that intersect: no
/// finite translation parts them.
///
/// Of two meshes `find_contacts({bolt}, {nut, pose})` is that of mesh_contacts.h: say
/// `{Shape(bolt)}` where a manifold is meant.
template <typename = void>
Manifold find_contacts(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                       Work* work = nullptr);

/// How find_contacts() of two shapes looks for contacts.
struct ManifoldSettings {
  /// Contacts begin when the two are so near, metres: finite and not negative.
  double margin = 0;
  MeshSides sides_a = {};  ///< what of A counts beside its surface, if it is a mesh
  MeshSides sides_b = {};  ///< likewise of B
};

/// The same with a margin: empty exactly when the two are apart by more than it, as distance()
/// says, or by its lower bound where that has not converged. The contacts are those of A grown by
/// the margin along the normal, by the same definition, and as they lie on A itself: a depth may be
/// negative, down to minus the margin, where the surfaces are apart along the normal by that much.
/// Of two that do not touch no depth is above 0. A mesh grows triangle by triangle, to its front;
/// where all that is near is behind it, as for a ball inside a closed mesh, the one contact is that
/// of the nearest points. Of two meshes what is near along one direction, to two degrees, is one
/// region, and belongs to one that touches along it; its features are those of meshes that touch.
///
/// Points are on the surfaces as without a margin, to the same tolerances, of two that are apart as
/// of two that touch, however their faces lean. So is where they are to each other, but that beside
/// a mesh what does not touch may lie aside of the normal. Along it they are the depth apart, to
/// 1e-6 of the smaller size and the margin and 2^-30 of the scale.
///
/// What does not touch, and is on the inner side of a mesh whose sides count, has contacts, too:
/// one region, in front of which it is once it has moved by the greatest depth. A solid is left by
/// the shortest way out through a triangle that the body then lies before, as far as triangles
/// about as near as that way is long say; a surface with a front by the nearest triangle's. What
/// touches as well is led out by what it touches, as ever.
///
/// With a margin of 0 and surfaces alone these are the contacts of above, bit for bit. Throws as
/// above; InputError for a margin that is negative, infinite or NaN, for sides of what is no mesh,
/// and for a thickness that is none; MeshError, with the edge, for a mesh that does not tell its
/// sides apart. Costs up to a distance() more.
template <typename = void>
Manifold find_contacts(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                       const ManifoldSettings& settings, Work* work = nullptr);

}  // namespace graze

template <>
struct std::hash<graze::ContactFeature> {
  std::size_t operator()(const graze::ContactFeature& feature) const noexcept {
    return graze::hash_of({feature.a, feature.b});
  }
};
