#pragma once

#include <graze/engine/mesh/io/text_cursor.h>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace graze::mesh_io {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
enum class PlyEncoding { Ascii, BinaryLittleEndian, BinaryBigEndian };

/// The meanings that a property may have for a mesh.
enum class PlyRole { None, X, Y, Z, Corners };

/// A column of an element: one value to a row or, with a count, a list of them.
struct PlyProperty {
  std::string_view name;
  PlyType type;
  std::optional<PlyType> count_type;
  PlyRole role = PlyRole::None;
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  Place place;
  std::vector<PlyProperty> properties;
};

/// The header of a file. Names are views of the file.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
};

/// Returns how many bytes a binary value has.
std::size_t size_of(PlyType type);

/// Reads the header and leaves the cursor at the first byte of the data. Finds coordinates and
/// corners; fails if they are missing, ambiguous or of a kind that is not supported.
PlyHeader read_ply_header(const Source& source, TextCursor& cursor);

}  // namespace graze::mesh_io
