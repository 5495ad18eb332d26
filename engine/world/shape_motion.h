#pragma once

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/shape.h>

namespace graze {

/// When two shapes in rigid motion meet first (law 14); a mesh, too, may be one of the two, and two
/// meshes are asked as first_contact() of meshes is. `low` is found by going as far as the lower
/// bound of the distance lasts at the greatest speed of any point, in steps of a grid in each of
/// which nothing moves by more than a quarter of the tolerance: so it is never later than the first
/// contact, and at `low` that bound is not above clearance and tolerance. `high` is a time at which
/// intersects() says yes, or the distance is within the clearance. The tolerance is at least 2^-28
/// of all lengths that shapes and motions are made of; a budget counts distances. Throws as
/// first_contact() of meshes does, and UnsupportedPairError for two half-spaces of which one turns.
RigidContact first_contact(const Shape& shape_a, const RigidMotion& motion_a, const Shape& shape_b,
                           const RigidMotion& motion_b, const RigidContactSettings& settings = {},
                           Work* work = nullptr);

/// Whether first_contact() says Free.
bool is_free(const Shape& shape_a, const RigidMotion& motion_a, const Shape& shape_b,
             const RigidMotion& motion_b, const RigidContactSettings& settings = {},
             Work* work = nullptr);

}  // namespace graze
