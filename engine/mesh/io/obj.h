#pragma once

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/mesh_builder.h>

namespace graze::mesh_io {

/// Wavefront OBJ, polygons only. Vertices may have a weight or a colour behind the coordinates;
/// corners may be i, i/t, i//n or i/t/n; indices may be negative, or name vertices that come later.
/// Statements of the format that carry no surface are skipped; free-form surfaces, and statements
/// that the format does not know, are errors.
MeshArrays read_obj(const Source& source);

}  // namespace graze::mesh_io
