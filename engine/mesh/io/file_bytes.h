#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace graze::mesh_io {

/// Throws MeshError, beginning with `name`, unless the path leads to a regular file.
void require_regular_file(const std::filesystem::path& path, std::string_view name);

/// Reads the whole file. Throws MeshError if it is empty or cannot be read. Memory follows what is
/// read, not what the file system says of its size.
std::string read_file(const std::filesystem::path& path, std::string_view name);

}  // namespace graze::mesh_io
