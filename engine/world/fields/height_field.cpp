#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/fields/field_data.h>
#include <graze/engine/world/fields/field_tiles.h>
#include <graze/engine/world/shape.h>

#include <atomic>
#include <cmath>
#include <string>
#include <utility>

namespace graze {
namespace {

// Features of contacts have 30 bits for a triangle.
constexpr std::uint64_t kMostHeights = std::uint64_t{1} << 29;

[[noreturn]] void refuse(const std::string& what, ErrorPlace place = {}) {
  throw InputError("height field: " + what, std::move(place));
}

void check_spacing(double spacing, std::uint32_t count, const char* name) {
  if (!std::isfinite(spacing) || !(spacing >= kSmallestLength)) {
    refuse(std::string("the ") + name + " is " + std::to_string(spacing) +
           ", but must be finite and at least the smallest length");
  }
  if (!((count - 1) * spacing <= kLargestLength))
    refuse(std::string("with this ") + name + " it reaches beyond the largest length");
}

void check_count(std::size_t found, std::uint64_t wanted, const char* what) {
  if (found == wanted) return;
  refuse(std::to_string(found) + " " + what + ", not " + std::to_string(wanted));
}

void check_settings(std::uint32_t columns, std::uint32_t rows,
                    const HeightFieldSettings& settings) {
  if (columns < 2 || rows < 2) {
    refuse(std::to_string(columns) + " columns and " + std::to_string(rows) +
           " rows, but there must be 2 of each");
  }
  if (std::uint64_t{columns} * rows >= kMostHeights) refuse("2^29 heights or more");
  check_spacing(settings.spacing_x, columns, "spacing in x");
  check_spacing(settings.spacing_y, rows, "spacing in y");
  if (!std::isfinite(settings.height_scale) || !(settings.height_scale > 0)) {
    refuse("the scale of heights is " + std::to_string(settings.height_scale) +
           ", but must be finite and above 0");
  }
  if (!(std::abs(settings.height_offset) <= kLargestLength))
    refuse("the offset of heights is not finite or beyond the largest length");
  const std::uint64_t cells = std::uint64_t{columns - 1} * (rows - 1);
  if (!settings.holes.empty()) check_count(settings.holes.size(), cells, "holes");
  if (!settings.materials.empty()) check_count(settings.materials.size(), cells, "materials");
}

template <typename Height>
void check_heights(const HeightFieldData& data, const FieldRange& part,
                   std::span<const Height> heights) {
  check_count(heights.size(), std::uint64_t{part.columns} * part.rows, "heights");
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double z = data.z(static_cast<float>(heights[i]));
    if (std::abs(z) <= kLargestLength) continue;
    const std::string place = "the height in column " +
                              std::to_string(part.first_column + i % part.columns) + ", row " +
                              std::to_string(part.first_row + i / part.columns);
    refuse(place + (std::isfinite(static_cast<double>(heights[i])) ? " is beyond the largest length"
                                                                   : " is not finite"),
           {.element = "height", .index = i});
  }
}

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

/// Returns the data of a field with these settings, without its tiles.
HeightFieldData data_of(std::uint32_t columns, std::uint32_t rows,
                        const HeightFieldSettings& settings) {
  check_settings(columns, rows, settings);
  HeightFieldData data;
  data.columns = columns, data.rows = rows;
  data.spacing_x = settings.spacing_x, data.spacing_y = settings.spacing_y;
  data.height_scale = settings.height_scale, data.height_offset = settings.height_offset;
  data.serial = next_serial();
  return data;
}

template <typename Height>
std::shared_ptr<const HeightFieldData> made(std::uint32_t columns, std::uint32_t rows,
                                            std::span<const Height> heights,
                                            const HeightFieldSettings& settings) {
  return bvh::in_standard_arithmetic([&]() -> std::shared_ptr<const HeightFieldData> {
    auto data = std::make_shared<HeightFieldData>(data_of(columns, rows, settings));
    data->has_floats = std::is_same_v<Height, float>;
    check_heights(*data, {0, 0, columns, rows}, heights);
    make_tiles(*data, heights, settings);
    data->finish();
    if (data->upper.back().front().is_empty()) refuse("all cells are holes");
    return data;
  });
}

template <typename Height>
std::shared_ptr<const HeightFieldData> replaced(const HeightFieldData& before,
                                                const FieldRange& part,
                                                std::span<const Height> heights) {
  return bvh::in_standard_arithmetic([&]() -> std::shared_ptr<const HeightFieldData> {
    const std::uint64_t last_column = std::uint64_t{part.first_column} + part.columns;
    const std::uint64_t last_row = std::uint64_t{part.first_row} + part.rows;
    if (part.columns == 0 || part.rows == 0 || last_column > before.columns ||
        last_row > before.rows) {
      refuse("columns " + std::to_string(part.first_column) + " to " + std::to_string(last_column) +
             " and rows " + std::to_string(part.first_row) + " to " + std::to_string(last_row) +
             " are no part of " + std::to_string(before.columns) + " columns and " +
             std::to_string(before.rows) + " rows");
    }
    if (before.has_floats != std::is_same_v<Height, float>)
      refuse(before.has_floats ? "its heights are floats" : "its heights have 16 bits");
    check_heights(before, part, heights);
    auto data = std::make_shared<HeightFieldData>(before);
    data->serial = next_serial();
    replace_heights(*data, part, heights);
    data->finish();
    return data;
  });
}

}  // namespace

HeightField::HeightField(std::uint32_t columns, std::uint32_t rows, std::span<const float> heights,
                         const HeightFieldSettings& settings)
    : data_(made(columns, rows, heights, settings)) {}

HeightField::HeightField(std::uint32_t columns, std::uint32_t rows,
                         std::span<const std::uint16_t> heights,
                         const HeightFieldSettings& settings)
    : data_(made(columns, rows, heights, settings)) {}

HeightField HeightField::with_heights(const FieldRange& part,
                                      std::span<const float> heights) const {
  return HeightField(replaced(*data_, part, heights));
}

HeightField HeightField::with_heights(const FieldRange& part,
                                      std::span<const std::uint16_t> heights) const {
  return HeightField(replaced(*data_, part, heights));
}

std::uint32_t HeightField::columns() const {
  return data_->columns;
}

std::uint32_t HeightField::rows() const {
  return data_->rows;
}

Eigen::Vector3d HeightField::vertex(std::uint32_t column, std::uint32_t row) const {
  return bvh::in_standard_arithmetic(
      [&]() -> Eigen::Vector3d { return data_->vertex(column, row); });
}

bool HeightField::is_hole(std::uint32_t column, std::uint32_t row) const {
  return data_->is_hole(column, row);
}

std::uint8_t HeightField::material(std::uint32_t column, std::uint32_t row) const {
  return data_->material(column, row);
}

Triangle HeightField::triangle(std::uint32_t number) const {
  return bvh::in_standard_arithmetic([&]() -> Triangle { return data_->triangle(number); });
}

const Aabb& HeightField::bounds() const {
  return data_->bounds;
}

std::size_t HeightField::bytes() const {
  std::size_t bytes = sizeof(HeightFieldData) + data_->tiles.capacity() * sizeof(data_->tiles[0]);
  for (const std::shared_ptr<const FieldTile>& tile : data_->tiles)
    bytes += tile->bytes();
  for (const std::vector<HeightRange>& level : data_->upper)
    bytes += level.capacity() * sizeof(HeightRange);
  return bytes;
}

Mesh HeightField::mesh() const {
  return bvh::in_standard_arithmetic([&]() -> Mesh {
    std::vector<Eigen::Vector3d> vertices;
    vertices.reserve(std::size_t{data_->columns} * data_->rows);
    for (std::uint32_t r = 0; r < data_->rows; ++r) {
      for (std::uint32_t c = 0; c < data_->columns; ++c)
        vertices.push_back(data_->vertex(c, r));
    }
    std::vector<TriangleIndices> triangles;
    std::vector<std::uint16_t> materials;  // the materials, none if all are 0
    for (std::uint32_t r = 0; r + 1 < data_->rows; ++r) {
      for (std::uint32_t c = 0; c + 1 < data_->columns; ++c) {
        if (data_->is_hole(c, r)) continue;
        const std::uint32_t low = data_->vertex_number(c, r), high = low + data_->columns + 1;
        triangles.push_back({low, low + 1, high});
        triangles.push_back({low, high, high - 1});
        if (data_->has_materials) materials.insert(materials.end(), 2, data_->material(c, r));
      }
    }
    if (materials.empty()) return Mesh(vertices, triangles);
    return Mesh(vertices, triangles, materials);
  });
}

}  // namespace graze
