#pragma once

// The data that the handles of one height field share. Private to engine/world.

#include <graze/engine/world/height_field.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace graze {

/// The least and the greatest stored height of some cells; low > high if all are holes.
struct HeightRange {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();

  bool is_empty() const { return low > high; }
  void add(float height) { low = std::min(low, height), high = std::max(high, height); }
  void add(const HeightRange& other) {
    low = std::min(low, other.low), high = std::max(high, other.high);
  }
};

/// A rectangle of cells of a field, from the first up to but without the last; it may be empty.
struct CellRect {
  std::uint32_t first_column = 0, first_row = 0;
  std::uint32_t last_column = 0, last_row = 0;

  bool is_empty() const { return first_column >= last_column || first_row >= last_row; }
  std::uint64_t count() const {
    return is_empty() ? 0 : std::uint64_t{last_column - first_column} * (last_row - first_row);
  }
  bool operator==(const CellRect&) const = default;
};

/// A square of cells: those whose column and row, divided by width(), are its column and row. A
/// square of one level holds 4 by 4 squares of the level below.
struct CellSquare {
  static constexpr std::uint32_t kBlock = 8;  ///< the number of cells along a side of a square of
                                              ///< level 0
  static constexpr int kShift = 2;

  int level = 0;
  std::uint32_t column = 0, row = 0;

  std::uint64_t width() const { return std::uint64_t{kBlock} << (kShift * level); }
};

/// The heights and cells whose column and row, divided by kSide, are the same. It is immutable, and
/// shared by the fields that with_heights() makes of each other.
struct FieldTile {
  static constexpr std::uint32_t kSide = 128;
  static constexpr int kLevel = 2;  ///< the level of the square that a tile is
  static constexpr std::uint32_t kBlocks = kSide / CellSquare::kBlock;

  std::uint32_t columns = 0;  ///< the number of columns of heights in this tile
  std::uint32_t rows = 0;
  std::vector<float> floats;  ///< one of these two is empty
  std::vector<std::uint16_t> shorts;
  std::vector<std::uint8_t> materials;  ///< the materials of kSide rows of kSide cells; empty if
                                        ///< all are 0
  std::vector<std::uint64_t> holes;  ///< two words of bits for each of kSide rows; empty if there
                                     ///< is no hole
  std::vector<HeightRange> blocks;   ///< the ranges of kBlocks rows of kBlocks squares
  std::vector<HeightRange> groups;   ///< the ranges of 4 rows of 4 squares, of 4 by 4 blocks each
  HeightRange all;
  CellRect cells;  ///< the smallest rectangle around all cells that are no holes

  float stored(std::uint32_t column, std::uint32_t row) const {
    const std::size_t at = std::size_t{row} * columns + column;
    return floats.empty() ? static_cast<float>(shorts[at]) : floats[at];
  }
  bool is_hole(std::uint32_t column, std::uint32_t row) const {
    return !holes.empty() && (holes[2 * row + column / 64] >> (column % 64) & 1) != 0;
  }
  std::size_t bytes() const;
};

struct HeightFieldData {
  std::uint32_t columns = 0, rows = 0;  ///< the numbers of columns and rows of heights
  double spacing_x = 1, spacing_y = 1, height_scale = 1, height_offset = 0;
  bool has_floats = true;
  bool has_materials = false;  ///< whether any material is not 0
  std::uint64_t serial = 0;    ///< a number that no two fields share
  std::uint32_t tile_columns = 0, tile_rows = 0;
  std::vector<std::shared_ptr<const FieldTile>> tiles;
  /// The ranges of squares above the tiles: those of level kLevel + 1 + i, row by row. The last
  /// level has one square.
  std::vector<std::vector<HeightRange>> upper;
  Aabb bounds;

  std::uint32_t cell_columns() const { return columns - 1; }
  std::uint32_t cell_rows() const { return rows - 1; }
  CellRect cells() const { return {0, 0, cell_columns(), cell_rows()}; }

  const FieldTile& tile_at(std::uint32_t column, std::uint32_t row) const {
    constexpr std::uint32_t kSide = FieldTile::kSide;
    return *tiles[std::size_t{row / kSide} * tile_columns + column / kSide];
  }
  float stored(std::uint32_t column, std::uint32_t row) const {
    return tile_at(column, row).stored(column % FieldTile::kSide, row % FieldTile::kSide);
  }
  bool is_hole(std::uint32_t column, std::uint32_t row) const {
    return tile_at(column, row).is_hole(column % FieldTile::kSide, row % FieldTile::kSide);
  }
  std::uint8_t material(std::uint32_t column, std::uint32_t row) const {
    const FieldTile& tile = tile_at(column, row);
    if (tile.materials.empty()) return 0;
    return tile.materials[row % FieldTile::kSide * FieldTile::kSide + column % FieldTile::kSide];
  }

  /// These three functions define the surface: each operation is rounded. Rounding is monotone, so
  /// that a height between two others gives a point between theirs.
  double x(std::uint32_t column) const { return column * spacing_x; }
  double y(std::uint32_t row) const { return row * spacing_y; }
  double z(float height) const {
    const double scaled = height_scale * static_cast<double>(height);
    return scaled + height_offset;
  }
  Eigen::Vector3d vertex(std::uint32_t column, std::uint32_t row) const {
    return {x(column), y(row), z(stored(column, row))};
  }
  std::uint32_t vertex_number(std::uint32_t column, std::uint32_t row) const {
    return row * columns + column;
  }
  /// Returns the number of the first triangle of a cell.
  std::uint32_t triangle_number(std::uint32_t column, std::uint32_t row) const {
    return 2 * (row * cell_columns() + column);
  }
  Triangle triangle(std::uint32_t number) const;

  /// Returns the square of all cells.
  CellSquare root() const;
  /// Returns the cells of a square that the field has.
  CellRect cells_of(const CellSquare& square) const;
  HeightRange range_of(const CellSquare& square) const;
  /// Returns the box around cells whose heights are in a range.
  Aabb box_of(const CellRect& cells, const HeightRange& range) const;

  /// Calls `visit(square)` for those of the 4 by 4 squares below a square that have cells.
  template <typename Visit>
  void for_children(const CellSquare& square, const Visit& visit) const {
    const std::uint32_t column = square.column << CellSquare::kShift;
    const std::uint32_t row = square.row << CellSquare::kShift;
    for (std::uint32_t r = row; r < row + 4; ++r) {
      for (std::uint32_t c = column; c < column + 4; ++c) {
        const CellSquare child{square.level - 1, c, r};
        if (!cells_of(child).is_empty()) visit(child);
      }
    }
  }

  /// Computes the rest from tiles that have their heights and cells.
  void finish();
};

/// Gives access to the data of a height field.
struct HeightFieldAccess {
  static const HeightFieldData& data(const HeightField& field) { return *field.data_; }
};

}  // namespace graze
