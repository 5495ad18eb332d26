#include "data/generator/parts/lathe.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace graze::generator {
namespace {

/// A column as the strip beside it sees it.
struct StripSide {
  const Column& points;
  const std::vector<std::uint32_t>& vertices;
  Winding winding;
  int turns;  // how often the axis has been gone around: 1 for the first column as the last one's
              // neighbour

  std::pair<int, int> key(std::size_t i) const {
    const ColumnPoint& p = points[i];
    const int shift = p.section == winding.section ? turns * winding.lines_per_turn : 0;
    return {p.section, p.line - shift};
  }
};

void join(Surface& surface, const StripSide& side_a, const StripSide& side_b) {
  std::size_t i = 0;
  std::size_t j = 0;
  const auto& a = side_a.vertices;
  const auto& b = side_b.vertices;
  while (i + 1 < a.size() || j + 1 < b.size()) {
    const bool is_a_left = i + 1 < a.size();
    const bool is_b_left = j + 1 < b.size();
    if (is_a_left && is_b_left && side_a.key(i + 1) == side_b.key(j + 1)) {
      surface.quadrangle(a[i], b[j], b[j + 1], a[i + 1]);
      ++i;
      ++j;
    } else if (is_a_left && (!is_b_left || side_a.key(i + 1) < side_b.key(j + 1))) {
      surface.triangle(a[i], b[j], a[i + 1]);
      ++i;
    } else {
      surface.triangle(a[i], b[j], b[j + 1]);
      ++j;
    }
  }
}

}  // namespace

Surface turn_on_lathe(const std::vector<Column>& columns, const Winding& winding) {
  Surface surface;
  std::vector<std::vector<std::uint32_t>> vertices;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(columns.size());
    auto& column = vertices.emplace_back();
    for (const ColumnPoint& p : columns[i]) {
      column.push_back(surface.vertex({p.r * std::cos(angle), p.r * std::sin(angle), p.z}));
    }
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool is_last = i + 1 == columns.size();
    const std::size_t next = is_last ? 0 : i + 1;
    join(surface, {columns[i], vertices[i], winding, 0},
         {columns[next], vertices[next], winding, is_last ? 1 : 0});
  }
  return surface;
}

}  // namespace graze::generator
