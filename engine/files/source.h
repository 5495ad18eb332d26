#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace graze::mesh_io {

/// Holds a file in memory, with the name that its errors begin with. Both are borrowed.
struct Source {
  std::string_view name;
  std::string_view bytes;
};

/// Says where in a file something stands: a line counted from 1, or a byte counted from 0.
struct Place {
  enum class Unit { Line, Byte };
  Unit unit = Unit::Line;
  std::uint64_t at = 0;
};

/// Throws MeshError `name: why`.
[[noreturn]] void fail(const Source& source, std::string_view why);

/// Throws MeshError `name:LINE: why` or `name: byte N: why`.
[[noreturn]] void fail(const Source& source, Place place, std::string_view why);

/// Returns the text in double quotes, cut after 30 characters, with every byte that is not
/// printable ASCII written as \xNN: a message stays one short line whatever the file holds.
std::string quoted(std::string_view text);

/// Returns the name of a file for messages: line breaks and other control characters are written as
/// \xNN.
std::string printable(std::string_view name);

}  // namespace graze::mesh_io
