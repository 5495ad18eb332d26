#pragma once

#include <filesystem>

#include "data/generator/surface.h"

namespace graze::generator {

/// Each writes the surface, whose coordinates are metres, and throws std::runtime_error, naming the
/// file, if it cannot. Text formats keep all digits of a double; STL holds floats.
void write_obj(const std::filesystem::path& path, const Surface& surface);
void write_off(const std::filesystem::path& path, const Surface& surface);
void write_binary_stl(const std::filesystem::path& path, const Surface& surface);
void write_binary_ply(const std::filesystem::path& path, const Surface& surface);

}  // namespace graze::generator
