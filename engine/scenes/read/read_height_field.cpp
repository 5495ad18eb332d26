// Reads terrains of scenes: their heights stand in the file itself, or raw in another one.

#include <graze/bvh/error.h>
#include <graze/engine/scenes/read/scene_parts.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace graze::scenes {
namespace {

using cases::at_place;
using cases::JsonCursor;

// HeightField has this limit, too; it is asked here so that no product overflows before.
constexpr std::uint32_t kMostHeights = (1u << 29) - 1;

/// Says how many heights there are along both ways.
struct FieldSize {
  std::uint32_t columns, rows;
  std::size_t heights() const { return std::size_t{columns} * rows; }
  std::size_t cells() const { return std::size_t{columns - 1} * (rows - 1); }
};

std::uint32_t read_count(const JsonCursor& at) {
  const std::uint32_t count = at.index(kMostHeights);
  if (count < 2) at.fail("is " + std::to_string(count) + "; a field has at least 2 each way");
  return count;
}

FieldSize read_size(const JsonCursor& at) {
  const FieldSize size{read_count(at.member("columns")), read_count(at.member("rows"))};
  if (size.heights() > kMostHeights) {
    at.fail("has " + std::to_string(size.heights()) + " heights, more than " +
            std::to_string(kMostHeights));
  }
  return size;
}

void require_count(const JsonCursor& at, std::size_t count, const FieldSize& size,
                   const char* what) {
  if (at.size() == count) return;
  at.fail("has " + std::to_string(at.size()) + " " + what + "; " + std::to_string(size.columns) +
          " columns and " + std::to_string(size.rows) + " rows have " + std::to_string(count));
}

std::vector<float> read_heights(const JsonCursor& at, const FieldSize& size) {
  require_count(at, size.heights(), size, "heights");
  std::vector<float> heights(size.heights());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double height = at.item(i).number();
    // The cast of a number beyond that range would be undefined.
    if (!(std::abs(height) <= std::numeric_limits<float>::max()))
      at.item(i).fail("is beyond the range of float");
    heights[i] = static_cast<float>(height);
  }
  return heights;
}

std::vector<std::uint8_t> read_holes(const JsonCursor& at, const FieldSize& size) {
  std::vector<std::uint8_t> holes(size.cells(), 0);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const JsonCursor cell = at.item(i);
    cell.require_size(2);
    const std::uint32_t column = cell.item(0).index(size.columns - 2);
    holes[std::size_t{cell.item(1).index(size.rows - 2)} * (size.columns - 1) + column] = 1;
  }
  return holes;
}

std::vector<std::uint8_t> read_materials(const JsonCursor& at, const FieldSize& size) {
  require_count(at, size.cells(), size, "materials of cells");
  std::vector<std::uint8_t> materials(size.cells());
  for (std::size_t i = 0; i < materials.size(); ++i)
    materials[i] = static_cast<std::uint8_t>(at.item(i).index(0xff));
  return materials;
}

/// Returns the bytes of a number, the least first.
template <typename Bits>
Bits bits_at(const std::string& bytes, std::size_t index) {
  Bits bits = 0;
  for (std::size_t i = sizeof(Bits); i-- > 0;)
    bits =
        static_cast<Bits>(bits << 8 | static_cast<std::uint8_t>(bytes[index * sizeof(Bits) + i]));
  return bits;
}

/// Returns what `make(heights)` makes of the numbers of a file.
template <typename Bits, typename Height, typename Make>
HeightField from_bytes(const JsonCursor& at, const std::string& bytes, const FieldSize& size,
                       const Make& make) {
  const std::size_t wanted = size.heights() * sizeof(Bits);
  if (bytes.size() != wanted) {
    at.fail("the file has " + std::to_string(bytes.size()) + " bytes; " +
            std::to_string(size.columns) + " columns and " + std::to_string(size.rows) +
            " rows of this format have " + std::to_string(wanted));
  }
  std::vector<Height> heights(size.heights());
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = std::bit_cast<Height>(bits_at<Bits>(bytes, i));
  return make(std::span<const Height>(heights));
}

}  // namespace

HeightField read_height_field(const JsonCursor& at, const SceneUnits& units, MeshFiles& files) {
  at.require_keys({"columns", "rows", "heights", "file", "format", "sha256", "spacing",
                   "height_scale", "height_offset", "holes", "materials"});
  if (at.has("heights") == at.has("file")) at.fail("has heights or a file, one of the two");
  if (at.has("file") != at.has("format")) at.fail("a file needs a format, and a format a file");
  if (at.has("sha256") && !at.has("file")) at.member("sha256").fail("is of a file");
  const FieldSize size = read_size(at);
  std::vector<std::uint8_t> holes, materials;
  if (at.has("holes")) holes = read_holes(at.member("holes"), size);
  if (at.has("materials")) materials = read_materials(at.member("materials"), size);
  const JsonCursor spacing = at.member("spacing");
  spacing.require_size(2);
  HeightFieldSettings settings{.spacing_x = units.read_length(spacing.item(0)),
                               .spacing_y = units.read_length(spacing.item(1)),
                               .height_scale = units.length.to_metres(1),
                               .holes = holes,
                               .materials = materials};
  if (at.has("height_scale")) settings.height_scale = units.read_length(at.member("height_scale"));
  if (at.has("height_offset"))
    settings.height_offset = units.read_length(at.member("height_offset"));
  const auto make = [&](const auto& heights) {
    return at_place(at, [&] { return HeightField(size.columns, size.rows, heights, settings); });
  };
  if (at.has("heights")) {
    const std::vector<float> heights = read_heights(at.member("heights"), size);
    return make(std::span<const float>(heights));
  }
  const JsonCursor format = at.member("format");
  if (format.text() != "uint16" && format.text() != "float32")
    format.fail("is none of uint16 and float32");
  const std::string bytes = files.read_bytes(at);
  const JsonCursor place = at.member("file");
  if (format.text() == "uint16")
    return from_bytes<std::uint16_t, std::uint16_t>(place, bytes, size, make);
  return from_bytes<std::uint32_t, float>(place, bytes, size, make);
}

}  // namespace graze::scenes
