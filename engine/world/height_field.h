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

/// How a height field lies in its own frame, and what its cells are.
struct HeightFieldSettings {
  double spacing_x = 1;      ///< metres between columns, from kSmallestLength on
  double spacing_y = 1;      ///< metres between rows, likewise
  double height_scale = 1;   ///< metres for one unit of a stored height: finite and above 0
  double height_offset = 0;  ///< metres added to each height
  /// For each cell, row by row, (columns - 1) (rows - 1) in all, other than 0 where there is none;
  /// empty if the field has no holes.
  std::span<const std::uint8_t> holes = {};
  /// For each cell likewise what it is made of, a number for the user; empty if all are 0.
  std::span<const std::uint8_t> materials = {};
};

/// Columns and rows of heights: those from the first on, so many.
struct FieldRange {
  std::uint32_t first_column = 0;  ///< the first that belongs to it
  std::uint32_t first_row = 0;     ///< likewise
  std::uint32_t columns = 0;       ///< how many there are
  std::uint32_t rows = 0;          ///< likewise

  bool operator==(const FieldRange&) const = default;
};

/// A terrain: heights over a grid, without a triangle in memory. Height h in column c and row r is
/// the point (c spacing_x, r spacing_y, h height_scale + height_offset), each operation rounded to
/// double. Between columns c and c + 1 and rows r and r + 1 lies a cell of two triangles, along the
/// diagonal that goes up in both: (c, r), (c + 1, r), (c + 1, r + 1) and (c, r), (c + 1, r + 1),
/// (c, r + 1), which turn counter-clockwise as seen from above. The field is the surface that these
/// triangles form, but for holes, and what is said of it is what is said of mesh(), bit for bit,
/// but for what of a mesh depends on its tree: the last bits of a distance's lower bound, times of
/// casts within their tolerance and what is met then.
///
/// A value: a copy is a handle to the same immutable heights, safe to use from many threads. Stored
/// are the heights as they are given, 4 bytes for each float or 2 for each 16-bit number, a byte
/// for the material of a cell if any is not 0, a bit for a hole if there is one, and an eighth of a
/// byte for each cell, by which queries find cells.
///
/// Vertex (c, r) has the number r columns + c, and the triangles of the cell between (c, r) and
/// (c + 1, r + 1) the numbers 2 (r (columns - 1) + c) and that plus 1, whether or not others are
/// holes: features of contacts and RayHit::triangle are these.
class HeightField {
 public:
  /// Heights row by row: columns times rows of them, 2 at least each way, and fewer than 2^29.
  /// Throws InputError, with the row and the column, for a height that is not finite; for a wrong
  /// number of heights, holes or materials; for settings that are none; if all is hole; and for
  /// what reaches beyond kLargestLength. O(columns rows).
  HeightField(std::uint32_t columns, std::uint32_t rows, std::span<const float> heights,
              const HeightFieldSettings& settings = {});
  /// Takes 16-bit heights, and is like the constructor above in all else.
  HeightField(std::uint32_t columns, std::uint32_t rows, std::span<const std::uint16_t> heights,
              const HeightFieldSettings& settings = {});

  /// How many heights a row has, and how many rows there are.
  std::uint32_t columns() const;
  std::uint32_t rows() const;

  /// The point of a height in the field's frame, metres. Nothing is checked, here and in what
  /// follows.
  Eigen::Vector3d vertex(std::uint32_t column, std::uint32_t row) const;
  /// Whether there is no cell from that column and row to the next.
  bool is_hole(std::uint32_t column, std::uint32_t row) const;
  /// What that cell is made of.
  std::uint8_t material(std::uint32_t column, std::uint32_t row) const;
  /// A triangle by its number.
  Triangle triangle(std::uint32_t number) const;

  /// The field with other heights in a part of it, row by row: all else is shared with this one, in
  /// tiles of 128 by 128 heights. Throws InputError, which names the place, for what is no part of
  /// the field, for a wrong number of heights, for one that is not finite or beyond
  /// kLargestLength, and for floats where heights have 16 bits, or the other way round. O(heights
  /// in the tiles that the part and the cells around it touch, and tiles).
  HeightField with_heights(const FieldRange& part, std::span<const float> heights) const;
  /// Takes 16-bit heights, and is like the function above in all else.
  HeightField with_heights(const FieldRange& part, std::span<const std::uint16_t> heights) const;

  /// The smallest box around all triangles, metres, exactly.
  const Aabb& bounds() const;

  /// How many bytes it takes, which handles and fields made by with_heights() share.
  std::size_t bytes() const;

  /// The mesh of these triangles: all vertices in the order of their numbers, and the triangles
  /// likewise, without those of holes, with the materials of their cells.
  Mesh mesh() const;

  /// True if both are handles to the same field.
  friend bool operator==(const HeightField& a, const HeightField& b) { return a.data_ == b.data_; }

 private:
  friend struct HeightFieldAccess;
  explicit HeightField(std::shared_ptr<const HeightFieldData> data) : data_(std::move(data)) {}

  std::shared_ptr<const HeightFieldData> data_;
};

}  // namespace graze
