#pragma once

// These decide for Interior::Solid and Hit::Solid when no surfaces touch. They are private to the
// library.

#include <graze/engine/mesh/interior.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>

namespace graze {

/// Throw InputError for a value that the enumeration does not have.
void check_interior(Interior interior);
void check_hit(Hit hit);

/// Returns which triangles are a hit by themselves.
Touch touch_of(Hit hit);

/// True if either of two solids holds a part of the other. The meshes must be closed, and their
/// placed surfaces must share no point. A connected part of one surface then lies wholly inside or
/// wholly outside the other solid, so that one vertex decides for it. It stops at the first that is
/// inside.
bool is_either_inside(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Work& work);

}  // namespace graze
