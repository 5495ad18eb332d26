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

/// Names what meets in a contact: corners, edges and faces by numbers of the shape's own, which are
/// the same in every pose. Where the same features meet in the next step, the numbers are the same,
/// so that a solver can start from what it found before; ContactTracker says which contacts go on
/// (contact_tracker.h). A feature is unique within a manifold.
struct ContactFeature {
  std::uint64_t a;  ///< the feature of A, by a number of its own
  std::uint64_t b;  ///< the feature of B
  auto operator<=>(const ContactFeature&) const = default;
};

/// One point in which two shapes meet.
struct ShapeContact {
  Eigen::Vector3d point;    ///< midway between point_a and point_b, metres, in the world's frame
  Eigen::Vector3d point_a;  ///< on A's surface
  Eigen::Vector3d point_b;  ///< on B's surface
  Eigen::Vector3d normal;   ///< unit, from A to B
  double depth;             ///< how far the two reach past each other here, metres; negative only
                            ///< where a margin was asked for: minus how far they are apart
  ContactFeature feature;   ///< what of the two shapes meets here
  std::uint32_t region;     ///< contacts of one region share a way out; see Manifold
  /// The material of A there: that of the triangle of a mesh, or of the cell of a height field,
  /// that is nearest to point_a, and of several that of the least number. It is 0 for shapes
  /// without materials. How two materials combine is the user's to say.
  std::uint16_t material_a;
  std::uint16_t material_b;  ///< the material of B at point_b

  bool operator==(const ShapeContact&) const = default;
};

/// The contacts of a pair, region by region. Each region has at most four contacts, which stand for
/// all of it, its deepest first; the region with the deepest contact comes first. Where two bodies
/// meet in several regions, as a plank that lies on two trestles or a box in a corner, each region
/// has its own normal. Two convex bodies meet in one region. Four contacts take no memory beyond
/// the manifold's own.
class Manifold {
 public:
  static constexpr std::size_t kMostOfRegion = 4;  ///< the most contacts of one region

  Manifold() = default;
  /// Takes over the memory of `other`, which is left without contacts.
  Manifold(Manifold&& other) noexcept { *this = std::move(other); }
  Manifold& operator=(Manifold&& other) noexcept;
  /// Copies only the contacts that are in use, mostly one or two of four.
  Manifold(const Manifold& other) { *this = other; }
  Manifold& operator=(const Manifold& other);

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const ShapeContact* begin() const { return data(); }
  const ShapeContact* end() const { return data() + count_; }
  const ShapeContact& operator[](std::size_t index) const { return data()[index]; }
  /// Returns a contact that may be changed in place.
  ShapeContact& operator[](std::size_t index) { return data()[index]; }

  /// Return the number of regions, and the contacts of one.
  std::size_t region_count() const { return count_ == 0 ? 0 : (*this)[count_ - 1].region + 1; }
  std::span<const ShapeContact> region(std::size_t index) const;

  /// Return and set the parts of A and of B that meet, if the bodies are compounds in a world; else
  /// 0.
  std::uint32_t part_a() const { return part_a_; }
  std::uint32_t part_b() const { return part_b_; }
  void set_parts(std::uint32_t of_a, std::uint32_t of_b) { part_a_ = of_a, part_b_ = of_b; }

  void clear() { count_ = 0; }
  /// Adds a contact of the last region, or of a new one after it; there may be more than four.
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
  std::size_t capacity_ = 0;                     ///< how many contacts `all_` has room for
  std::unique_ptr<ShapeContact[]> all_;          ///< the contacts, if there are more than four
  std::array<ShapeContact, kMostOfRegion> few_;  ///< the contacts otherwise
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

/// Returns the contacts of two placed shapes, as a solver needs them; the manifold is empty exactly
/// when intersects() is false.
///
/// **Convex shapes.** All contacts share one normal. Let the tolerance be 1e-6 of the smaller size
/// plus kTouchTolerance of the scale (shape_pairs.h). The width by which the two reach past each
/// other along the normal is the least over all directions, to that tolerance. This is proved,
/// unless Work::penetration_failures counts the pair; then the width still parts the two, but
/// nothing says how near it is to the least. For two boxes the least may be smaller, but is at
/// least 19 twentieths of the width, but for the tolerance, because a face is taken where two edges
/// would be nearer by less than that. If the poses are not rotations up to rounding, the tolerance
/// grows by their deviation times the scale. The greatest depth of the contacts is that width, to
/// the tolerance and to a thousandth, of two boxes to a twentieth, of what parts the two along the
/// normal. A motion by d changes the width by at most d and the tolerance. A cylinder's cap and a
/// cone's base count as octagons, except for how deep they are.
///
/// **Meshes** are one-sided: their triangles turn counter-clockwise as seen from outside, and a
/// body behind a surface leaves it in front. Law 15 (narrowphase/README.md) says what a region is
/// and which way leads out of it: a direction that a face, a convex edge or a corner of a mesh
/// faces. So a polyhedron has the same contacts as the closed mesh of its surface, however that is
/// tessellated: the greatest depth to a twentieth, its normal to a degree or one that parts the two
/// as well, while the depth is at most a tenth of the smaller body. Edges between triangles of one
/// plane have no effect. Each contact has its own depth: a body that leans is deepest where it
/// leans. Regions between two walls that are too near to each other to satisfy both are all listed.
/// Where a shape touches only triangles without height, each is parted from it along the shortest
/// way. Where the deepest point lies beyond the triangles that are touched, as in a valley, a
/// region's contact is less deep than its way out. Curves of two meshes that do not close, where a
/// mesh is open or where rounding tears them, count as one piece as far as triangles connect them.
/// A piece that wraps around, as that of a nut on a bolt, has a region for each triangle through
/// which it has to be left. Meshes that only touch, in a plane, along a line or in a point, have
/// the contacts of their find_contacts() (mesh_contacts.h).
///
/// **Points.** Each point_a is on A's surface and each point_b on B's, however deep the two are, to
/// 2^-32 of the scale of the pair (their sizes and the distance of their middles) and the rounding
/// of world coordinates. Where faces, or edges along each other, meet, and above a half-space,
/// point_a - point_b is depth times normal, to the same tolerance. Where one point of each meets,
/// the two are where the shapes touch once they are parted: to 2^-17 of the smaller one's size and
/// 2^-30 of the scale, or 2^-16 of the scale if one is a sphere or a capsule; but no better than
/// the depth is known to be the least, which for a box and a box or a mesh is to a twentieth of it,
/// and not at all if Work::penetration_failures counts the pair. For two meshes, up to the depths
/// of law 15, one of the points is on its surface, to 1e-9 of the scale; the other is as near to
/// the plane of a face there, or across the normal where a corner or an edge is left: it lies
/// beside its surface where that is curved, and where faces lie in each other but for rounding as
/// far as the first body reaches. For deeper contacts, and for a hit that a search left open
/// (PairStatus::NotConverged), no surface is promised.
///
/// Of all contacts that a region offers four remain: the deepest, and those that are far from all
/// others that remain. Where all are nearly as deep, as under a body that lies, their places alone
/// decide; then one of them moves within the region to where it is deep enough, and keeps its
/// feature, so that its point may be beside the corner that the feature names. So that features
/// persist, edges of two faces that are within a 256th of the smaller shape's size of each other
/// count as one; no answer of yes or no depends on this. Where such an edge ends the common area,
/// its corners slide along their face onto that end, and keep their names. Swapping A and B mirrors
/// the result, bit for bit: normals turn round, and features change places. For equal shapes in
/// equal poses there is nothing to mirror, as the swapped question is the same one: then the result
/// is the same, too. Throws as intersects() does, and UnsupportedPairError for two half-spaces that
/// intersect, because no finite translation parts them.
///
/// For two meshes `find_contacts({bolt}, {nut, pose})` is the function of mesh_contacts.h: write
/// `{Shape(bolt)}` where a manifold is meant.
template <typename = void>
Manifold find_contacts(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                       Work* work = nullptr);

/// The settings of find_contacts() of two shapes.
struct ManifoldSettings {
  /// Contacts begin when the two are no further apart than this, metres: finite and not negative.
  double margin = 0;
  MeshSides sides_a = {};  ///< what counts as a part of A beside its surface, if A is a mesh
  MeshSides sides_b = {};  ///< the same for B
};

/// Returns the contacts of two placed shapes with a margin: the manifold is empty exactly when the
/// two are apart by more than the margin, as distance() says, or its lower bound where that has not
/// converged. By the same definition the contacts are those of A grown by the margin along the
/// normal, placed as they lie on A itself: a depth may be negative, down to minus the margin, where
/// the surfaces are apart along the normal by that much. If the two do not touch, no depth is above
/// 0. A mesh grows triangle by triangle, to its front; where all that is near is behind it, as for
/// a ball inside a closed mesh, the one contact is that of the nearest points. For two meshes all
/// that is near along one direction, to two degrees, is one region, and belongs to a region that
/// touches along it; its features are those of meshes that touch.
///
/// Points are on the surfaces as without a margin, to the same tolerances, whether the two are
/// apart or touch, and however their faces lean. The two points of a contact also lie to each other
/// as without a margin, except that beside a mesh those of a contact that does not touch may lie
/// aside of the normal. Along the normal they are the depth apart, to 1e-6 of the smaller size and
/// the margin and 2^-30 of the scale.
///
/// A body that does not touch, but is on the inner side of a mesh whose sides count, has contacts,
/// too: one region, in front of which the body is once it has moved by the greatest depth. It
/// leaves a solid by the shortest way through a triangle or past an edge or corner of it, as far as
/// the triangles that are about as near as that way is long can tell; a surface with a front along
/// the normal of the nearest triangle, or straight ahead past a border. A body that touches as well
/// is led out by what it touches, as without sides.
///
/// With a margin of 0 and surfaces alone these are the contacts without settings, bit for bit.
/// Throws as find_contacts() without settings does; InputError for a margin that is negative,
/// infinite or NaN, for sides of a shape that is no mesh, and for an invalid thickness; and
/// MeshError, with the edge, for a mesh that does not tell its sides apart. It costs up to one
/// distance() more.
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
