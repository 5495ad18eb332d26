#pragma once

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/mesh_builder.h>

namespace graze::mesh_io {

/// Polygon File Format 1.0, ASCII or binary of either byte order. Coordinates are the properties x,
/// y, z of element vertex, of any type; faces the list vertex_indices or vertex_index of element
/// face. Other elements and properties are skipped, except that corners in another element
/// (triangle strips) are an error.
MeshArrays read_ply(const Source& source);

}  // namespace graze::mesh_io
