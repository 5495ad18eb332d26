#pragma once

#include <filesystem>

#include "data/generator/surface.h"

namespace graze::generator {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };
enum class PlyCoordinates { Float, Double };
enum class PlyIndices { Ushort, Uint };

struct PlyLayout {
  PlyEncoding encoding = PlyEncoding::LittleEndian;
  PlyCoordinates coordinates = PlyCoordinates::Double;
  PlyIndices indices = PlyIndices::Uint;
};

/// Each writes the surface, whose coordinates are metres, and throws std::runtime_error, naming the
/// file, if it cannot. Text formats keep all digits of a double; STL holds floats, PLY what its
/// layout says.
void write_obj(const std::filesystem::path& path, const Surface& surface);
void write_off(const std::filesystem::path& path, const Surface& surface);
void write_binary_stl(const std::filesystem::path& path, const Surface& surface);
void write_ply(const std::filesystem::path& path, const Surface& surface,
               const PlyLayout& layout = {});

}  // namespace graze::generator
