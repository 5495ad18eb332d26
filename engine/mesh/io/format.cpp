#include <graze/engine/mesh/io/format.h>
#include <graze/engine/mesh/io/readers.h>
#include <graze/engine/mesh/io/text_cursor.h>
#include <algorithm>
#include <array>

namespace graze::mesh_io {
namespace {

constexpr std::array<Format, 4> kFormats = {
    {{".obj", read_obj}, {".stl", read_stl}, {".ply", read_ply}, {".off", read_off}}};

}  // namespace

std::span<const Format> all_formats() {
  return kFormats;
}

const Format* find_format(std::string_view extension) {
  const auto found = std::ranges::find_if(
      kFormats, [&](const Format& format) { return is_keyword(extension, format.extension); });
  return found == kFormats.end() ? nullptr : &*found;
}

}  // namespace graze::mesh_io
