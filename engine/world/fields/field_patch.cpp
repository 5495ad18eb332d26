#include <graze/engine/mesh/data/mesh_patch.h>
#include <graze/engine/world/fields/field_patch.h>
#include <graze/engine/world/fields/field_tree.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace graze {

namespace {

/// Some columns of one row, from the first up to but without the last.
struct Span {
  std::uint32_t row, first, last;
  std::size_t before = 0;  ///< how many columns all spans before have
};

/// Sorts spans row by row, and joins those that touch.
void merge(std::vector<Span>& spans) {
  std::sort(spans.begin(), spans.end(), [](const Span& s, const Span& t) {
    return s.row != t.row ? s.row < t.row : s.first < t.first;
  });
  std::size_t kept = 0, count = 0;
  for (const Span& span : spans) {
    if (kept > 0 && spans[kept - 1].row == span.row && spans[kept - 1].last >= span.first) {
      Span& last = spans[kept - 1];
      count += std::max(last.last, span.last) - last.last;
      last.last = std::max(last.last, span.last);
      continue;
    }
    spans[kept] = span;
    spans[kept++].before = count;
    count += span.last - span.first;
  }
  spans.resize(kept);
}

/// Returns the index of a vertex among those of the spans.
std::uint32_t index_in(const std::vector<Span>& spans, std::uint32_t row, std::uint32_t column) {
  const auto after =
      std::upper_bound(spans.begin(), spans.end(), std::pair(row, column),
                       [](const std::pair<std::uint32_t, std::uint32_t>& at, const Span& span) {
                         return at.first != span.row ? at.first < span.row : at.second < span.first;
                       });
  const Span& span = *(after - 1);
  return static_cast<std::uint32_t>(span.before + (column - span.first));
}

void add_vertices(const HeightFieldData& field, const std::vector<Span>& spans, MeshPatch& patch) {
  const std::size_t count = spans.back().before + (spans.back().last - spans.back().first);
  patch.vertices.reserve(count);
  patch.vertex_numbers.reserve(count);
  for (const Span& span : spans) {
    for (std::uint32_t c = span.first; c < span.last; ++c) {
      patch.vertices.push_back(field.vertex(c, span.row));
      patch.vertex_numbers.push_back(field.vertex_number(c, span.row));
    }
  }
}

void add_triangles(const HeightFieldData& field, const std::vector<Span>& cells,
                   const std::vector<Span>& vertices, MeshPatch& patch) {
  const std::size_t count = 2 * (cells.back().before + (cells.back().last - cells.back().first));
  patch.triangles.reserve(count);
  patch.triangle_numbers.reserve(count);
  for (const Span& span : cells) {
    std::uint32_t low = index_in(vertices, span.row, span.first);
    std::uint32_t high = index_in(vertices, span.row + 1, span.first);
    for (std::uint32_t c = span.first; c < span.last; ++c, ++low, ++high) {
      if (field.is_hole(c, span.row)) continue;
      const std::uint32_t number = field.triangle_number(c, span.row);
      patch.triangles.push_back({low, low + 1, high + 1});
      patch.triangles.push_back({low, high + 1, high});
      patch.triangle_numbers.push_back(number);
      patch.triangle_numbers.push_back(number + 1);
    }
  }
}

/// Marks the vertices that lie where the rectangle ends and the field does not.
void mark_rim(const HeightFieldData& field, const CellRect& rect, MeshPatch& patch) {
  const bool is_below = rect.first_row > 0, is_above = rect.last_row < field.cell_rows();
  const bool is_left = rect.first_column > 0;
  const bool is_right = rect.last_column < field.cell_columns();
  patch.is_rim.reserve(patch.vertices.size());
  for (std::uint32_t r = rect.first_row; r <= rect.last_row; ++r) {
    const bool is_row = (is_below && r == rect.first_row) || (is_above && r == rect.last_row);
    for (std::uint32_t c = rect.first_column; c <= rect.last_column; ++c) {
      patch.is_rim.push_back(is_row || (is_left && c == rect.first_column) ||
                             (is_right && c == rect.last_column));
    }
  }
}

/// Makes the patch of one rectangle, which needs no list of spans.
MeshPatch patch_of_rect(const HeightFieldData& field, const CellRect& rect) {
  MeshPatch patch;
  patch.bounds = field.bounds;
  const std::uint32_t columns = rect.last_column - rect.first_column + 1;
  const std::size_t count = std::size_t{columns} * (rect.last_row - rect.first_row + 1);
  patch.vertices.reserve(count);
  patch.vertex_numbers.reserve(count);
  for (std::uint32_t r = rect.first_row; r <= rect.last_row; ++r) {
    for (std::uint32_t c = rect.first_column; c <= rect.last_column; ++c) {
      patch.vertices.push_back(field.vertex(c, r));
      patch.vertex_numbers.push_back(field.vertex_number(c, r));
    }
  }
  mark_rim(field, rect, patch);
  patch.triangles.reserve(2 * rect.count());
  patch.triangle_numbers.reserve(2 * rect.count());
  for (std::uint32_t r = rect.first_row; r < rect.last_row; ++r) {
    std::uint32_t low = (r - rect.first_row) * columns;
    for (std::uint32_t c = rect.first_column; c < rect.last_column; ++c, ++low) {
      if (field.is_hole(c, r)) continue;
      const std::uint32_t number = field.triangle_number(c, r), high = low + columns;
      patch.triangles.push_back({low, low + 1, high + 1});
      patch.triangles.push_back({low, high + 1, high});
      patch.triangle_numbers.push_back(number);
      patch.triangle_numbers.push_back(number + 1);
    }
  }
  return patch;
}

}  // namespace

Mesh patch_of(const HeightFieldData& field, std::span<const CellRect> rects) {
  if (rects.size() == 1) {
    MeshPatch patch = patch_of_rect(field, rects[0]);
    patch.tree = tree_over(field, rects[0], patch);
    return mesh_of(std::move(patch));
  }
  std::vector<Span> cells, vertices;
  for (const CellRect& rect : rects) {
    for (std::uint32_t r = rect.first_row; r < rect.last_row; ++r)
      cells.push_back({r, rect.first_column, rect.last_column});
  }
  merge(cells);
  for (const Span& span : cells) {
    vertices.push_back({span.row, span.first, span.last + 1});
    vertices.push_back({span.row + 1, span.first, span.last + 1});
  }
  merge(vertices);
  MeshPatch patch;
  patch.bounds = field.bounds;
  add_vertices(field, vertices, patch);
  add_triangles(field, cells, vertices, patch);
  return mesh_of(std::move(patch));
}

namespace {

struct KeptPatch {
  std::uint64_t serial;
  CellRect rect;
  Mesh mesh;
};

std::size_t place_of(std::uint64_t serial, const CellRect& rect, std::size_t places) {
  std::uint64_t mixed = serial;
  for (const std::uint32_t each :
       {rect.first_column, rect.first_row, rect.last_column, rect.last_row})
    mixed = (mixed ^ each) * 0x9E3779B97F4A7C15u;
  return static_cast<std::size_t>(mixed >> 32) % places;
}

}  // namespace

Mesh kept_patch_of(const HeightFieldData& field, const CellRect& rect) {
  // A cell takes some 140 bytes, so that these are 20 MB at the very most.
  constexpr std::size_t kMostKept = 512;
  constexpr std::uint64_t kMostCells = 256;
  if (rect.count() > kMostCells) return patch_of(field, std::span(&rect, 1));
  static thread_local std::vector<std::optional<KeptPatch>> kept(kMostKept);
  std::optional<KeptPatch>& place = kept[place_of(field.serial, rect, kept.size())];
  if (!place || place->serial != field.serial || !(place->rect == rect))
    place = KeptPatch{field.serial, rect, patch_of(field, std::span(&rect, 1))};
  return place->mesh;
}

}  // namespace graze
