#pragma once

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/mesh_builder.h>

namespace graze::mesh_io {

/// STL, ASCII or binary. A file is binary if it has exactly the size that its triangle count asks
/// for, or if it does not look like text that begins with "solid": many binary files begin with
/// this word too. Bit-equal positions become one vertex. Normals and attributes are skipped.
MeshArrays read_stl(const Source& source);

MeshArrays read_stl_ascii(const Source& source);
MeshArrays read_stl_binary(const Source& source);

/// A binary file is a header, a count, and so many bytes for each triangle.
inline constexpr std::size_t kStlHeaderBytes = 80;
inline constexpr std::size_t kStlTriangleBytes = 50;

}  // namespace graze::mesh_io
