#pragma once

#include <filesystem>

namespace graze::generator {

/// Writes all bundled meshes and poses to `directory`/meshes and `directory`/poses, which are
/// created if need be. Throws std::runtime_error, naming the file, if it cannot.
void generate(const std::filesystem::path& directory);

}  // namespace graze::generator
