#include <graze/engine/world/fields/field_tiles.h>

#include <algorithm>
#include <utility>

namespace graze {

namespace {

constexpr std::uint32_t kSide = FieldTile::kSide;

std::vector<float>& heights_of(FieldTile& tile, float /*kind*/) {
  return tile.floats;
}
std::vector<std::uint16_t>& heights_of(FieldTile& tile, std::uint16_t /*kind*/) {
  return tile.shorts;
}

/// Returns the range of heights of a tile by its number.
FieldRange range_of(const HeightFieldData& data, std::size_t tile) {
  const auto column = static_cast<std::uint32_t>(tile % data.tile_columns) * kSide;
  const auto row = static_cast<std::uint32_t>(tile / data.tile_columns) * kSide;
  return {column, row, std::min(kSide, data.columns - column), std::min(kSide, data.rows - row)};
}

template <typename Height>
FieldTile tile_of_heights(const HeightFieldData& data, std::size_t number,
                          std::span<const Height> heights) {
  const FieldRange range = range_of(data, number);
  FieldTile tile;
  tile.columns = range.columns, tile.rows = range.rows;
  std::vector<Height>& own = heights_of(tile, Height{});
  own.reserve(std::size_t{range.columns} * range.rows);
  for (std::uint32_t r = range.first_row; r < range.first_row + range.rows; ++r) {
    const auto row =
        heights.subspan(std::size_t{r} * data.columns + range.first_column, range.columns);
    own.insert(own.end(), row.begin(), row.end());
  }
  return tile;
}

/// Calls `visit(column, row, index)` for the cells of a tile; the column and the row in the tile,
/// the index in the field.
template <typename Visit>
void for_cells(const HeightFieldData& data, std::size_t number, const Visit& visit) {
  const FieldRange range = range_of(data, number);
  const std::uint32_t columns = std::min(range.columns, data.cell_columns() - range.first_column);
  const std::uint32_t rows = std::min(range.rows, data.cell_rows() - range.first_row);
  for (std::uint32_t r = 0; r < rows; ++r) {
    const std::size_t row = std::size_t{range.first_row + r} * data.cell_columns();
    for (std::uint32_t c = 0; c < columns; ++c)
      visit(c, r, row + range.first_column + c);
  }
}

void set_cells(const HeightFieldData& data, std::size_t number, const HeightFieldSettings& settings,
               FieldTile& tile) {
  bool has_holes = false, has_materials = false;
  for_cells(data, number, [&](std::uint32_t, std::uint32_t, std::size_t i) {
    has_holes |= !settings.holes.empty() && settings.holes[i] != 0;
    has_materials |= !settings.materials.empty() && settings.materials[i] != 0;
  });
  if (has_holes) tile.holes.assign(2 * kSide, 0);
  if (has_materials) tile.materials.assign(std::size_t{kSide} * kSide, 0);
  for_cells(data, number, [&](std::uint32_t c, std::uint32_t r, std::size_t i) {
    if (has_holes && settings.holes[i] != 0)
      tile.holes[2 * r + c / 64] |= std::uint64_t{1} << (c % 64);
    if (has_materials) tile.materials[std::size_t{r} * kSide + c] = settings.materials[i];
  });
}

template <typename Height>
void make_all(HeightFieldData& data, std::span<const Height> heights,
              const HeightFieldSettings& settings) {
  data.tile_columns = (data.columns + kSide - 1) / kSide;
  data.tile_rows = (data.rows + kSide - 1) / kSide;
  data.tiles.resize(std::size_t{data.tile_columns} * data.tile_rows);
  for (std::size_t i = 0; i < data.tiles.size(); ++i) {
    FieldTile tile = tile_of_heights(data, i, heights);
    set_cells(data, i, settings, tile);
    data.has_materials |= !tile.materials.empty();
    data.tiles[i] = std::make_shared<FieldTile>(std::move(tile));
  }
}

/// Copies the cells and heights of a tile, without what is computed from them.
std::shared_ptr<FieldTile> bare_copy(const FieldTile& tile) {
  auto copy = std::make_shared<FieldTile>();
  copy->columns = tile.columns, copy->rows = tile.rows;
  copy->floats = tile.floats, copy->shorts = tile.shorts;
  copy->materials = tile.materials, copy->holes = tile.holes;
  return copy;
}

template <typename Height>
void replace_all(HeightFieldData& data, const FieldRange& part, std::span<const Height> heights) {
  const std::uint32_t last_column = part.first_column + part.columns;
  const std::uint32_t last_row = part.first_row + part.rows;
  // A height is also a corner of the cell before it.
  const std::uint32_t before_column = std::max(part.first_column, 1u) - 1;
  const std::uint32_t before_row = std::max(part.first_row, 1u) - 1;
  for (std::uint32_t r = before_row / kSide; r <= (last_row - 1) / kSide; ++r) {
    for (std::uint32_t c = before_column / kSide; c <= (last_column - 1) / kSide; ++c) {
      const std::size_t number = std::size_t{r} * data.tile_columns + c;
      const std::shared_ptr<FieldTile> tile = bare_copy(*data.tiles[number]);
      const FieldRange range = range_of(data, number);
      std::vector<Height>& own = heights_of(*tile, Height{});
      const std::uint32_t from = std::max(part.first_column, range.first_column);
      const std::uint32_t to = std::min(last_column, range.first_column + range.columns);
      const std::uint32_t end_row = std::min(last_row, range.first_row + range.rows);
      for (std::uint32_t row = std::max(part.first_row, range.first_row); row < end_row; ++row) {
        for (std::uint32_t column = from; column < to; ++column) {
          own[std::size_t{row - range.first_row} * range.columns + (column - range.first_column)] =
              heights[std::size_t{row - part.first_row} * part.columns +
                      (column - part.first_column)];
        }
      }
      data.tiles[number] = tile;
    }
  }
}

/// Computes the ranges of the squares of a tile that lacks them.
void find_ranges(const HeightFieldData& data, std::size_t number, FieldTile& tile) {
  const FieldRange range = range_of(data, number);
  tile.blocks.assign(std::size_t{FieldTile::kBlocks} * FieldTile::kBlocks, {});
  tile.groups.assign(16, {});
  for_cells(data, number, [&](std::uint32_t c, std::uint32_t r, std::size_t) {
    if (tile.is_hole(c, r)) return;
    HeightRange of_cell;
    const std::uint32_t column = range.first_column + c, row = range.first_row + r;
    const bool is_within = c + 1 < tile.columns && r + 1 < tile.rows;
    for (std::uint32_t i = 0; i < 4; ++i) {
      of_cell.add(is_within ? tile.stored(c + i % 2, r + i / 2)
                            : data.stored(column + i % 2, row + i / 2));
    }
    tile.blocks[r / CellSquare::kBlock * FieldTile::kBlocks + c / CellSquare::kBlock].add(of_cell);
    CellRect& cells = tile.cells;
    if (cells.is_empty()) cells = {column, row, column + 1, row + 1};
    cells.first_column = std::min(cells.first_column, column);
    cells.last_column = std::max(cells.last_column, column + 1);
    cells.last_row = row + 1;
  });
  for (std::uint32_t i = 0; i < tile.blocks.size(); ++i) {
    const std::uint32_t column = i % FieldTile::kBlocks / 4, row = i / FieldTile::kBlocks / 4;
    tile.groups[row * 4 + column].add(tile.blocks[i]);
    tile.all.add(tile.blocks[i]);
  }
}

}  // namespace

void make_tiles(HeightFieldData& data, std::span<const float> heights,
                const HeightFieldSettings& settings) {
  make_all(data, heights, settings);
}

void make_tiles(HeightFieldData& data, std::span<const std::uint16_t> heights,
                const HeightFieldSettings& settings) {
  make_all(data, heights, settings);
}

void replace_heights(HeightFieldData& data, const FieldRange& part,
                     std::span<const float> heights) {
  replace_all(data, part, heights);
}

void replace_heights(HeightFieldData& data, const FieldRange& part,
                     std::span<const std::uint16_t> heights) {
  replace_all(data, part, heights);
}

std::size_t FieldTile::bytes() const {
  const auto of = [](const auto& list) { return list.capacity() * sizeof(list[0]); };
  return sizeof(FieldTile) + of(floats) + of(shorts) + of(materials) + of(holes) + of(blocks) +
         of(groups);
}

void HeightFieldData::finish() {
  CellRect around;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    // A tile without ranges was made for this field, and no other field has it yet.
    if (tiles[i]->blocks.empty()) find_ranges(*this, i, const_cast<FieldTile&>(*tiles[i]));
    const CellRect& cells = tiles[i]->cells;
    if (cells.is_empty()) continue;
    if (around.is_empty()) around = cells;
    around = {std::min(around.first_column, cells.first_column),
              std::min(around.first_row, cells.first_row),
              std::max(around.last_column, cells.last_column),
              std::max(around.last_row, cells.last_row)};
  }
  upper.clear();
  std::uint32_t below_columns = tile_columns, below_rows = tile_rows;
  do {
    const std::uint32_t columns_here = (below_columns + 3) / 4, rows_here = (below_rows + 3) / 4;
    std::vector<HeightRange> level(std::size_t{columns_here} * rows_here);
    for (std::uint32_t r = 0; r < below_rows; ++r) {
      for (std::uint32_t c = 0; c < below_columns; ++c) {
        const std::size_t at = std::size_t{r} * below_columns + c;
        level[std::size_t{r / 4} * columns_here + c / 4].add(upper.empty() ? tiles[at]->all
                                                                           : upper.back()[at]);
      }
    }
    upper.push_back(std::move(level));
    below_columns = columns_here, below_rows = rows_here;
  } while (below_columns > 1 || below_rows > 1);
  bounds = box_of(around, upper.back().front());
}

}  // namespace graze
