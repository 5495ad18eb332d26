#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

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
/// in `distance({Box{{1, 1, 1}}}, {hull, pose})`. It refers to both, which must outlive it, as
/// everything does that is written within a call; code that keeps a placed shape keeps a
/// PlacedShape.
struct PlacedShapeView {
  // NOLINTBEGIN(google-explicit-constructor): queries are asked about shapes and placed shapes
  /// Refers to a shape in its own frame, to a shape in a pose, or to a PlacedShape.
  PlacedShapeView(const Shape& of_shape);
  PlacedShapeView(const Shape& of_shape, const Pose& in_pose) : shape(of_shape), pose(in_pose) {}
  PlacedShapeView(const PlacedShape& placed) : shape(placed.shape), pose(placed.pose) {}
  // NOLINTEND(google-explicit-constructor)

  const Shape& shape;  ///< must outlive this
  const Pose& pose;    ///< must outlive this
};

}  // namespace graze
