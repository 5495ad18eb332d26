#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include <optional>
#include <type_traits>
#include <utility>

namespace graze {

/// A shape in a pose. It is a value, as a Shape is.
struct PlacedShape {
  Shape shape;                   ///< a handle, where it is a hull or a mesh
  Pose pose = Pose::Identity();  ///< the pose of the shape: it takes points of the shape's frame to
                                 ///< the world

  bool operator==(const PlacedShape& other) const {
    return shape == other.shape && are_equal(pose, other.pose);
  }
};

/// The argument of queries: a shape in a pose, made of a PlacedShape or within the call itself, as
/// in `distance({Box{{1, 1, 1}}}, {hull, pose})`. It refers to a Shape or a Pose that has a name,
/// which must outlive it, and holds one that has none, and what it has made a Shape of. Code that
/// keeps a placed shape keeps a PlacedShape.
struct PlacedShapeView {
  // NOLINTBEGIN(google-explicit-constructor): queries are asked about shapes and placed shapes
  /// Takes a shape in its own frame, a shape in a pose, or a PlacedShape.
  PlacedShapeView(const Shape& of_shape);
  PlacedShapeView(Shape&& of_shape);
  PlacedShapeView(const Shape& of_shape, const Pose& in_pose) : shape(of_shape), pose(in_pose) {}
  // Eigen returns poses such as Pose::Identity() as constants, which would be taken by reference
  // if these took Pose&&.
  PlacedShapeView(const Shape& of_shape, const Pose&& in_pose)
      : held_pose_(in_pose), shape(of_shape), pose(*held_pose_) {}
  PlacedShapeView(Shape&& of_shape, const Pose& in_pose)
      : held_shape_(std::move(of_shape)), shape(*held_shape_), pose(in_pose) {}
  PlacedShapeView(Shape&& of_shape, const Pose&& in_pose)
      : held_shape_(std::move(of_shape)),
        held_pose_(in_pose),
        shape(*held_shape_),
        pose(*held_pose_) {}
  PlacedShapeView(const PlacedShape& placed) : shape(placed.shape), pose(placed.pose) {}
  PlacedShapeView(PlacedShape&& placed)
      : PlacedShapeView(std::move(placed.shape), std::move(placed.pose)) {}

  /// Makes the shape where it is held, so that it is not moved there.
  template <typename Kind>
  requires(!std::is_same_v<Kind, Shape> && std::is_convertible_v<const Kind&, Shape>)
      PlacedShapeView(const Kind& of_kind, const Pose& in_pose)
      : held_shape_(std::in_place, of_kind), shape(*held_shape_), pose(in_pose) {}
  /// Holds the pose, too.
  template <typename Kind>
  requires(!std::is_same_v<Kind, Shape> && std::is_convertible_v<const Kind&, Shape>)
      PlacedShapeView(const Kind& of_kind, const Pose&& in_pose)
      : held_shape_(std::in_place, of_kind),
        held_pose_(in_pose),
        shape(*held_shape_),
        pose(*held_pose_) {}
  // NOLINTEND(google-explicit-constructor)

  /// Holds what `other` holds, and refers to what it refers to.
  PlacedShapeView(const PlacedShapeView& other)
      : held_shape_(other.held_shape_),
        held_pose_(other.held_pose_),
        shape(held_shape_ ? *held_shape_ : other.shape),
        pose(held_pose_ ? *held_pose_ : other.pose) {}
  PlacedShapeView& operator=(const PlacedShapeView&) = delete;
  ~PlacedShapeView() = default;

 private:
  std::optional<Shape> held_shape_;
  std::optional<Pose> held_pose_;

 public:
  const Shape& shape;  ///< must outlive this, if it has a name
  const Pose& pose;    ///< must outlive this, if it has a name
};

}  // namespace graze
