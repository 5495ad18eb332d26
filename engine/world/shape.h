#pragma once

#include <array>
#include <variant>

#include <graze/bvh/error.h>
#include <graze/bvh/sphere.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/height_field.h>
#include <graze/narrowphase/volumes/ellipsoid.h>
#include <Eigen/Core>

namespace graze {

// Value types in a body's own frame, metres, closed and solid. Sphere and Ellipsoid have a centre
// in it; the others are centred at its origin, with z as their axis.

/// [-half_extents, half_extents].
struct Box {
  Eigen::Vector3d half_extents;  ///< metres, along x, y and z

  bool operator==(const Box&) const = default;
};

/// The points at most `radius` from the segment between z = -half_length and z = half_length.
struct Capsule {
  double radius;       ///< metres
  double half_length;  ///< 0 is a sphere

  bool operator==(const Capsule&) const = default;
};

/// Between z = -half_height and z = half_height around the z axis.
struct Cylinder {
  double radius;       ///< metres
  double half_height;  ///< metres

  bool operator==(const Cylinder&) const = default;
};

/// The apex is at z = half_height, the base, of that radius, at z = -half_height.
struct Cone {
  double radius;       ///< of the base, metres
  double half_height;  ///< metres

  bool operator==(const Cone&) const = default;
};

/// The points x with normal . x <= offset.
struct HalfSpace {
  /// Outward; of any length but 0, and scaled to 1 by Shape, which leaves what is of that length to
  /// rounding as it is.
  Eigen::Vector3d normal;
  double offset = 0;  ///< for the normal as it is given

  bool operator==(const HalfSpace&) const = default;
};

/// The points x with normal . x == offset: a plane that has no inside, and both sides of which are
/// free. What is convex and lies on one side meets it as it meets the half-space behind it; what
/// reaches through it leaves it to the side where it has less to go. A mesh meets it where a
/// triangle does: one in several pieces may have some of them on either side, and be free.
struct Plane {
  Eigen::Vector3d normal;  ///< either of the two; of any length but 0, and scaled to 1 by Shape
  double offset = 0;       ///< for the normal as it is given

  bool operator==(const Plane&) const = default;
};

/// Which of the types a Shape is, in the order of Shape::Value.
enum class ShapeKind {
  Sphere,
  Box,
  Capsule,
  Cylinder,
  Cone,
  Ellipsoid,
  ConvexHull,
  HalfSpace,
  Mesh,
  HeightField,
  Plane
};

/// All of them, in their order.
inline constexpr std::array kShapeKinds{
    ShapeKind::Sphere, ShapeKind::Box,         ShapeKind::Capsule,    ShapeKind::Cylinder,
    ShapeKind::Cone,   ShapeKind::Ellipsoid,   ShapeKind::ConvexHull, ShapeKind::HalfSpace,
    ShapeKind::Mesh,   ShapeKind::HeightField, ShapeKind::Plane};

/// "sphere", "box", ... as error messages call it.
const char* name_of(ShapeKind kind);

/// Lengths of shapes are at least the smallest and at most the largest, and so are, at most,
/// coordinates of their poses: squares and products of six stay within double.
inline constexpr double kSmallestLength = 1e-100;
/// The largest: see kSmallestLength.
inline constexpr double kLargestLength = 1e100;

/// Any shape that a body can have; a value, and cheap to copy: hulls, meshes and height fields are
/// handles. The constructors are the door: they throw InputError, which names the shape and the
/// member, for what is not finite, not positive, or beyond the lengths above.
class Shape {
 public:
  /// What it can be.
  using Value = std::variant<Sphere, Box, Capsule, Cylinder, Cone, Ellipsoid, ConvexHull, HalfSpace,
                             Mesh, HeightField, Plane>;

  /// A shape is any of these: each converts to it.
  Shape(const Sphere& sphere);      // NOLINT(google-explicit-constructor): a shape is any of these
  Shape(const Box& box);            // NOLINT(google-explicit-constructor)
  Shape(const Capsule& capsule);    // NOLINT(google-explicit-constructor)
  Shape(const Cylinder& cylinder);  // NOLINT(google-explicit-constructor)
  Shape(const Cone& cone);          // NOLINT(google-explicit-constructor)
  Shape(const Ellipsoid& ellipsoid);   // NOLINT(google-explicit-constructor)
  Shape(ConvexHull hull);              // NOLINT(google-explicit-constructor)
  Shape(const HalfSpace& half_space);  // NOLINT(google-explicit-constructor)
  Shape(Mesh mesh);                    // NOLINT(google-explicit-constructor)
  Shape(HeightField field);            // NOLINT(google-explicit-constructor)
  Shape(const Plane& plane);           // NOLINT(google-explicit-constructor)

  /// Which of them it is.
  ShapeKind kind() const { return static_cast<ShapeKind>(value_.index()); }
  /// The shape itself.
  const Value& value() const { return value_; }

  /// The shape as one of the value types, or nullptr if it is another.
  template <typename T>
  const T* as() const {
    return std::get_if<T>(&value_);
  }

  /// True if both are of one type with the same numbers, or handles to the same.
  friend bool operator==(const Shape&, const Shape&) = default;

 private:
  Value value_;
};

}  // namespace graze
