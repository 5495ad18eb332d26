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

// The shapes are values in a body's own frame, metres, and closed. All are solid but Plane, meshes
// and height fields, which are surfaces. Sphere and Ellipsoid have a centre in that frame; Box,
// Capsule, Cylinder and Cone are centred at its origin, the last three with z as their axis; the
// others are where their numbers say.

/// The points from -half_extents to half_extents.
struct Box {
  Eigen::Vector3d half_extents;  ///< metres, along x, y and z

  bool operator==(const Box&) const = default;
};

/// The points at most `radius` from the segment between z = -half_length and z = half_length.
struct Capsule {
  double radius;       ///< metres
  double half_length;  ///< metres; if 0, the capsule is a sphere

  bool operator==(const Capsule&) const = default;
};

/// The points between z = -half_height and z = half_height that are at most `radius` from the z
/// axis.
struct Cylinder {
  double radius;       ///< metres
  double half_height;  ///< metres

  bool operator==(const Cylinder&) const = default;
};

/// A cone with its apex at z = half_height and its base at z = -half_height.
struct Cone {
  double radius;       ///< the radius of the base, metres
  double half_height;  ///< metres

  bool operator==(const Cone&) const = default;
};

/// The points x with normal . x <= offset.
struct HalfSpace {
  /// The outward normal, of any length but 0. Shape scales it to length 1, and leaves it as it is
  /// if it has that length up to rounding.
  Eigen::Vector3d normal;
  double offset = 0;  ///< metres, times the length of the normal as it is given

  bool operator==(const HalfSpace&) const = default;
};

/// The points x with normal . x == offset: a plane without an inside, both sides of which are free.
/// A convex shape on one side meets it as it meets the half-space behind it; one that reaches
/// through it leaves it to the side where it has less far to go. A mesh meets it where one of its
/// triangles does: a mesh in several pieces may have some of them on either side and not touch the
/// plane.
struct Plane {
  Eigen::Vector3d normal;  ///< either of the two normals, of any length but 0; Shape scales it to
                           ///< length 1
  double offset = 0;       ///< metres, times the length of the normal as it is given

  bool operator==(const Plane&) const = default;
};

/// The types that a Shape can have, in the order of Shape::Value.
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

/// All kinds of shapes, in their order.
inline constexpr std::array kShapeKinds{
    ShapeKind::Sphere, ShapeKind::Box,         ShapeKind::Capsule,    ShapeKind::Cylinder,
    ShapeKind::Cone,   ShapeKind::Ellipsoid,   ShapeKind::ConvexHull, ShapeKind::HalfSpace,
    ShapeKind::Mesh,   ShapeKind::HeightField, ShapeKind::Plane};

/// Returns the name of a kind in error messages: "sphere", "box", ...
const char* name_of(ShapeKind kind);

/// The smallest length of a shape, metres. With it and kLargestLength, which bounds coordinates of
/// poses, too, squares and products of up to six lengths stay within the range of double.
inline constexpr double kSmallestLength = 1e-100;
/// The largest length of a shape and the largest coordinate of a pose, metres.
inline constexpr double kLargestLength = 1e100;

/// Any shape that a body can have. It is a value, and cheap to copy, because hulls, meshes and
/// height fields are handles. The constructors check their arguments: they throw InputError, which
/// names the shape and the member, for numbers that are not finite, not positive, or beyond the
/// lengths above.
class Shape {
 public:
  /// The types that a shape can have.
  using Value = std::variant<Sphere, Box, Capsule, Cylinder, Cone, Ellipsoid, ConvexHull, HalfSpace,
                             Mesh, HeightField, Plane>;

  /// Each of these types converts to a shape.
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

  /// Returns the type of the shape.
  ShapeKind kind() const { return static_cast<ShapeKind>(value_.index()); }
  /// Returns the shape as a variant of all types.
  const Value& value() const { return value_; }

  /// Returns the shape as a T, or nullptr if it is of another type.
  template <typename T>
  const T* as() const {
    return std::get_if<T>(&value_);
  }

  /// True if both are of one type with the same numbers, or handles to the same data.
  friend bool operator==(const Shape&, const Shape&) = default;

 private:
  Value value_;
};

}  // namespace graze
