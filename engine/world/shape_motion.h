#pragma once

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/shape.h>

namespace graze {

/// Returns when two shapes in rigid motion meet first (law 14). Either may be a mesh; two meshes
/// are answered by first_contact() of meshes. The search for `low` goes on as long as the lower
/// bound of the distance lasts at the greatest speed of any point, in steps of a grid in each of
/// which nothing moves by more than a quarter of the tolerance. So `low` is never later than the
/// first contact, and at `low` that bound is at most the clearance and the tolerance together.
/// `high` is a time at which intersects() says yes, or the distance is within the clearance. The
/// tolerance is at least 2^-28 of all lengths that shapes and motions are made of. The budget
/// counts calls of distance(). Throws as first_contact() of meshes does, and UnsupportedPairError
/// for two half-spaces of which one turns.
RigidContact first_contact(const Shape& shape_a, const RigidMotion& motion_a, const Shape& shape_b,
                           const RigidMotion& motion_b, const RigidContactSettings& settings = {},
                           Work* work = nullptr);

/// True if first_contact() returns Free.
bool is_free(const Shape& shape_a, const RigidMotion& motion_a, const Shape& shape_b,
             const RigidMotion& motion_b, const RigidContactSettings& settings = {},
             Work* work = nullptr);

}  // namespace graze
