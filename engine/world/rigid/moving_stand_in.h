#pragma once

// Meshes that stand for height fields in motion. Private to engine/world.

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/fields/stand_in.h>
#include <graze/engine/world/rigid/moving_shape.h>

namespace graze {

/// For all that a shape may come near to in its motion, as near as the settings ask for, and cells
/// so far aside as FieldNeed has it. Beside a half-space all cells. Throws as MovingShape does.
StandIn moving_stand_in(const MovingShape& field, const MovingShape& other,
                        const RigidContactSettings& settings, double aside);

/// For a cast of the other by a displacement, metres, relative to the field, from 0 to a time: all
/// that is not met later.
StandIn cast_stand_in(const PlacedShapeView& field, const PlacedShapeView& other,
                      const Eigen::Vector3d& displacement);

}  // namespace graze
