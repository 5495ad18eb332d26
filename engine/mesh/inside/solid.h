#pragma once

// Interior::Solid: what is asked when no surfaces touch. Private to engine/mesh.

#include <graze/engine/mesh/interior.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>

namespace graze {

/// Throws InputError for an interior that is none, or together with Touch::Exclude: triangles that
/// touch without crossing say nothing about the solids.
void check_interior(const QuerySettings& settings);

/// For closed meshes whose placed surfaces share no point: whether either solid holds a part of the
/// other. A connected part of one surface then lies wholly inside or wholly outside the other
/// solid, so that one vertex decides for it. Stops at the first that is inside.
bool is_either_inside(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, Work& work);

}  // namespace graze
