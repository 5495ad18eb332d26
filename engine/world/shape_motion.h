#pragma once

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/shape.h>

namespace graze {

/// A shape in rigid motion, as the argument of queries: `first_contact({Box{{1, 1, 1}}, rest},
/// {hull, path})`. It is a value, as a Shape is. Of a MeshInMotion one is made in braces, as of any
/// shape: `{part.mesh, part.motion}`.
struct ShapeInMotion {
  Shape shape;         ///< a handle, where it is a hull or a mesh
  RigidMotion motion;  ///< where the shape is from t = 0 to 1

  bool operator==(const ShapeInMotion&) const = default;
};

/// Returns when two shapes in rigid motion meet first (law 14). Either may be a mesh; two meshes
/// are answered by first_contact() of meshes. The search for `low` goes on as long as the lower
/// bound of the distance lasts at the greatest speed of any point, in steps of a grid in each of
/// which nothing moves by more than a quarter of the tolerance. So `low` is never later than the
/// first contact, and at `low` that bound is at most the clearance and the tolerance together.
/// `high` is a time at which intersects() says yes, or the distance is within the clearance. The
/// tolerance is at least 2^-28 of all lengths that shapes and motions are made of. The budget
/// counts calls of distance(). Throws as first_contact() of meshes does, and UnsupportedPairError
/// for two half-spaces of which one turns. The functions are templates for the reason given in
/// shape_pairs.h.
template <typename = void>
RigidContact first_contact(const ShapeInMotion& shape_a, const ShapeInMotion& shape_b,
                           const RigidContactSettings& settings = {}, Work* work = nullptr);

/// True if first_contact() returns Free.
template <typename = void>
bool is_free(const ShapeInMotion& shape_a, const ShapeInMotion& shape_b,
             const RigidContactSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
