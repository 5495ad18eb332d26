#include <graze/engine/world/fields/field_data.h>

namespace graze {

CellSquare HeightFieldData::root() const {
  return {FieldTile::kLevel + static_cast<int>(upper.size()), 0, 0};
}

CellRect HeightFieldData::cells_of(const CellSquare& square) const {
  const auto cut = [&](std::uint64_t at, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(at * square.width(), most));
  };
  return {cut(square.column, cell_columns()), cut(square.row, cell_rows()),
          cut(std::uint64_t{square.column} + 1, cell_columns()),
          cut(std::uint64_t{square.row} + 1, cell_rows())};
}

HeightRange HeightFieldData::range_of(const CellSquare& square) const {
  if (square.level > FieldTile::kLevel) {
    const int above = square.level - FieldTile::kLevel;  // there are 4^above tiles along a side
    const std::uint32_t side = 1u << (CellSquare::kShift * above);
    const std::uint32_t columns_here = (tile_columns + side - 1) / side;
    return upper[static_cast<std::size_t>(above - 1)]
                [std::size_t{square.row} * columns_here + square.column];
  }
  const std::uint32_t per_tile = 1u << (CellSquare::kShift * (FieldTile::kLevel - square.level));
  const FieldTile& tile =
      *tiles[std::size_t{square.row / per_tile} * tile_columns + square.column / per_tile];
  const std::size_t at = square.row % per_tile * per_tile + square.column % per_tile;
  if (square.level == 0) return tile.blocks[at];
  return square.level == 1 ? tile.groups[at] : tile.all;
}

Aabb HeightFieldData::box_of(const CellRect& cells, const HeightRange& range) const {
  return {{x(cells.first_column), y(cells.first_row), z(range.low)},
          {x(cells.last_column), y(cells.last_row), z(range.high)}};
}

Triangle HeightFieldData::triangle(std::uint32_t number) const {
  const std::uint32_t cell = number / 2;
  const std::uint32_t c = cell % cell_columns(), r = cell / cell_columns();
  const Eigen::Vector3d low = vertex(c, r), high = vertex(c + 1, r + 1);
  if (number % 2 == 0) return {low, vertex(c + 1, r), high};
  return {low, high, vertex(c, r + 1)};
}

}  // namespace graze
