#pragma once

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/mesh_builder.h>

namespace graze::mesh_io {

/// Object File Format as text: OFF with any of the prefixes ST, C and N, one vertex or face to a
/// line. Normals, colours and texture coordinates are skipped. Binary files and those in four or in
/// n dimensions are errors.
MeshArrays read_off(const Source& source);

}  // namespace graze::mesh_io
