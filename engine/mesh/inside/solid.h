#pragma once

// Interior::Solid and Hit::Solid: what is asked when no surfaces touch. Private to the library.

#include <graze/engine/mesh/interior.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>

namespace graze {

/// Throw InputError for what is none.
void check_interior(Interior interior);
void check_hit(Hit hit);

/// Which triangles are a hit by themselves.
Touch touch_of(Hit hit);

/// For closed meshes whose placed surfaces share no point: whether either solid holds a part of the
/// other. A connected part of one surface then lies wholly inside or wholly outside the other
/// solid, so that one vertex decides for it. Stops at the first that is inside.
bool is_either_inside(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Work& work);

}  // namespace graze
