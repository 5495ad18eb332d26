#pragma once

// Makes stand-ins of height fields for questions about motions. Private to engine/world.

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/fields/stand_in.h>
#include <graze/engine/world/rigid/moving_shape.h>

namespace graze {

/// Returns a stand-in of all cells that a shape may come near to in its motion, as near as the
/// settings ask for, and of cells aside as in FieldNeed. Beside a half-space it has all cells.
/// Throws as MovingShape does.
StandIn moving_stand_in(const MovingShape& field, const MovingShape& other,
                        const RigidContactSettings& settings, double aside);

/// Returns a stand-in for a cast of the other shape by a displacement relative to the field,
/// metres, of all cells that it may meet on its way.
StandIn cast_stand_in(const PlacedShapeView& field, const PlacedShapeView& other,
                      const Eigen::Vector3d& displacement);

}  // namespace graze
