#pragma once

// Tells on which side of a surface a body is that does not touch it. Private to engine/world.

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape_pairs.h>

#include <Eigen/Core>

namespace graze {

/// Returns a point inside a convex body: for a hull the mean of its corners, else its middle.
Eigen::Vector3d inner_point(const PlacedShapeView& body);

/// True if a body is behind the surface of a mesh, where the two are nearest. They share no point,
/// and `nearest` is what distance() says of the body and the mesh.
bool is_behind(const PlacedShapeView& body, const PlacedMeshView& mesh,
               const ShapeDistance& nearest, Work& work);

}  // namespace graze
