#pragma once

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/mesh_builder.h>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace graze::mesh_io {

/// A kind of file: its names end with `extension`, in upper or lower case.
struct Format {
  std::string_view extension;
  MeshArrays (*read)(const Source& source, const ReadSettings& settings);
};

std::span<const Format> all_formats();

/// Returns where each triangle of a mesh file stands: the line or the byte at which its polygon
/// begins. Throws MeshError as load_mesh() does.
std::vector<Place> find_triangle_places(const std::filesystem::path& path);

/// Returns the format of this extension, which includes the dot; null if there is none.
const Format* find_format(std::string_view extension);

}  // namespace graze::mesh_io
