#pragma once

#include <filesystem>

#include <graze/engine/mesh/mesh.h>

namespace graze {

/// Reads OBJ, STL (ASCII and binary), PLY (ASCII and binary) or OFF, chosen by the file name's
/// ending. Coordinates keep all the digits that the file has. Polygons become triangles. Throws
/// MeshError with the file and the line or byte for whatever cannot be read; memory stays
/// proportional to the size of the file, whatever counts it claims.
Mesh load_mesh(const std::filesystem::path& path);

}  // namespace graze
