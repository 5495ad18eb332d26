#pragma once

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/mesh_builder.h>

namespace graze::mesh_io {

/// Reads STL, ASCII or binary. A file is binary if it has exactly the size that its triangle count
/// asks for, or if it does not look like text that begins with "solid": many binary files begin
/// with this word too. Bit-equal positions become one vertex. Normals and attributes are skipped.
MeshArrays read_stl(const Source& source, const ReadSettings& settings = {});

MeshArrays read_stl_ascii(const Source& source, const ReadSettings& settings = {});
MeshArrays read_stl_binary(const Source& source, const ReadSettings& settings = {});

/// The bytes of a binary file's header, before its count, and those of each triangle.
inline constexpr std::size_t kStlHeaderBytes = 80;
inline constexpr std::size_t kStlTriangleBytes = 50;

/// Reads Wavefront OBJ, polygons only. Vertices may have a weight or a colour behind the
/// coordinates; corners may be i, i/t, i//n or i/t/n; indices may be negative, or name vertices
/// that come later. Statements of the format that carry no surface are skipped; free-form surfaces,
/// and statements that the format does not know, are errors.
MeshArrays read_obj(const Source& source, const ReadSettings& settings = {});

/// Reads the Object File Format as text: OFF with any of the prefixes ST, C and N, one vertex or
/// face to a line. Normals, colours and texture coordinates are skipped. Binary files and those in
/// four or in n dimensions are errors.
MeshArrays read_off(const Source& source, const ReadSettings& settings = {});

/// Reads the Polygon File Format 1.0, ASCII or binary of either byte order. Coordinates are the
/// properties x, y, z of element vertex, of any type; faces are the list vertex_indices or
/// vertex_index of element face. Other elements and properties are skipped, except that corners in
/// another element (triangle strips) are an error.
MeshArrays read_ply(const Source& source, const ReadSettings& settings = {});

}  // namespace graze::mesh_io
