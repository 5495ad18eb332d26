#pragma once

#include <graze/bvh/aabb.h>
#include <graze/engine/mesh/mesh.h>
#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace graze {

struct HeightFieldData;

/// Says where the points of a height field lie in its own frame, and what its cells are.
struct HeightFieldSettings {
  double spacing_x = 1;      ///< metres between columns, from kSmallestLength on
  double spacing_y = 1;      ///< metres between rows, from kSmallestLength on
  double height_scale = 1;   ///< metres for one unit of a stored height: finite and above 0
  double height_offset = 0;  ///< metres added to each height
  /// One byte for each cell, row by row, (columns - 1) (rows - 1) in all: other than 0 where the
  /// cell is a hole. Empty if the field has no holes.
  std::span<const std::uint8_t> holes = {};
  /// One number for each cell, in the same order: its material, for the user. Empty if all are 0.
  std::span<const std::uint8_t> materials = {};
};

/// A rectangle of heights: some columns and some rows of the grid.
struct FieldRange {
  std::uint32_t first_column = 0;  ///< the first column of the range
  std::uint32_t first_row = 0;     ///< the first row of the range
  std::uint32_t columns = 0;       ///< the number of columns
  std::uint32_t rows = 0;          ///< the number of rows

  bool operator==(const FieldRange&) const = default;
};

/// A terrain: heights over a grid, without a triangle in memory. Height h in column c and row r is
/// the point (c spacing_x, r spacing_y, h height_scale + height_offset), each operation rounded to
/// double. Between columns c and c + 1 and rows r and r + 1 lies a cell of two triangles, along the
/// diagonal that goes up in both: (c, r), (c + 1, r), (c + 1, r + 1) and (c, r), (c + 1, r + 1),
/// (c, r + 1), which turn counter-clockwise as seen from above. The field is the surface that these
/// triangles form, but for holes, and all answers about it are those about mesh(), bit for bit,
/// except for answers that depend on the tree of a mesh: the last bits of a distance's lower bound,
/// times of casts within their tolerance and what is met then, and which of several points is named
/// where they are equally near.
///
/// A height field is a value: a copy is a handle to the same immutable heights, safe to use from
/// many threads. It stores the heights as they are given, 4 bytes for each float or 2 for each
/// 16-bit number; a byte for each cell if any material is not 0; a bit for each cell if there is a
/// hole; and an eighth of a byte for each cell, by which queries find cells.
///
/// Vertex (c, r) has the number r columns + c, and the triangles of the cell between (c, r) and
/// (c + 1, r + 1) the numbers 2 (r (columns - 1) + c) and that plus 1, whether or not others are
/// holes: features of contacts and RayHit::triangle are these.
class HeightField {
 public:
  /// Takes heights row by row: columns times rows of them, at least 2 each way, and fewer than 2^29
  /// in all. Throws InputError, with the row and the column, for a height that is not finite; for a
  /// wrong number of heights, holes or materials; for invalid settings; if all cells are holes; and
  /// for a field that reaches beyond kLargestLength. It costs O(columns rows).
  HeightField(std::uint32_t columns, std::uint32_t rows, std::span<const float> heights,
              const HeightFieldSettings& settings = {});
  /// Takes 16-bit heights, and is like the constructor above in all else.
  HeightField(std::uint32_t columns, std::uint32_t rows, std::span<const std::uint16_t> heights,
              const HeightFieldSettings& settings = {});

  /// Return the number of heights in a row, and the number of rows.
  std::uint32_t columns() const;
  std::uint32_t rows() const;

  /// Returns the point of a height in the field's frame, metres. Neither this function nor the next
  /// three check their arguments.
  Eigen::Vector3d vertex(std::uint32_t column, std::uint32_t row) const;
  /// True if there is a hole between this column and row and the next ones.
  bool is_hole(std::uint32_t column, std::uint32_t row) const;
  /// Returns the material of the cell there.
  std::uint8_t material(std::uint32_t column, std::uint32_t row) const;
  /// Returns a triangle by its number.
  Triangle triangle(std::uint32_t number) const;

  /// Returns the field with other heights, row by row, in a part of it: all else is shared with
  /// this one, in tiles of 128 by 128 heights. Throws InputError, which names the place, for a
  /// range that is no part of the field, for a wrong number of heights, for a height that is not
  /// finite or beyond kLargestLength, and for floats where heights have 16 bits, or the other way
  /// round. The cost grows with the heights in the tiles that the part and the cells around it
  /// touch, and with the number of tiles.
  HeightField with_heights(const FieldRange& part, std::span<const float> heights) const;
  /// Takes 16-bit heights, and is like the function above in all else.
  HeightField with_heights(const FieldRange& part, std::span<const std::uint16_t> heights) const;

  /// Returns the smallest box around all triangles, metres, exactly.
  const Aabb& bounds() const;

  /// Returns how many bytes the field takes. Copies share all of them, and fields made by
  /// with_heights() those of the tiles that they have in common.
  std::size_t bytes() const;

  /// Returns the mesh of the field: all vertices in the order of their numbers, and all triangles
  /// that are in no hole in the order of theirs, with the materials of their cells.
  Mesh mesh() const;

  /// True if both are handles to the same field.
  friend bool operator==(const HeightField& a, const HeightField& b) { return a.data_ == b.data_; }

 private:
  friend struct HeightFieldAccess;
  explicit HeightField(std::shared_ptr<const HeightFieldData> data) : data_(std::move(data)) {}

  std::shared_ptr<const HeightFieldData> data_;
};

}  // namespace graze
