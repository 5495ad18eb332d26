#include <graze/engine/world/fields/field_patch.h>
#include <graze/engine/world/fields/stand_in.h>
#include <graze/engine/world/shape_bounds.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace graze {

namespace {

// A patch of all cells above or below the other shape may have at most kMostAtOnce cells, or
// kFewCells if no cells aside are needed. If there are more, only near ones are taken.
constexpr std::uint64_t kFewCells = 1024;
constexpr std::uint64_t kMostAtOnce = std::uint64_t{1} << 16;

/// Returns a bound of the sine of the angle between the normals of triangles in these cells and
/// straight up; 1 if there are many cells.
double steepest_sine(const HeightFieldData& field, const CellRect& rect) {
  constexpr std::uint64_t kMostLookedAt = 256;
  if (rect.count() > kMostLookedAt) return 1;
  double square = 0;
  for (std::uint32_t r = rect.first_row; r < rect.last_row; ++r) {
    for (std::uint32_t c = rect.first_column; c < rect.last_column; ++c) {
      if (field.is_hole(c, r)) continue;
      const double low = field.z(field.stored(c, r)), beside = field.z(field.stored(c + 1, r));
      const double above = field.z(field.stored(c, r + 1));
      const double high = field.z(field.stored(c + 1, r + 1));
      const double x = std::max(std::abs(beside - low), std::abs(high - above)) / field.spacing_x;
      const double y = std::max(std::abs(above - low), std::abs(high - beside)) / field.spacing_y;
      square = std::max(square, x * x + y * y);
    }
  }
  return std::isfinite(square) ? std::min(std::sqrt(square / (1 + square)) + 0x1p-20, 1.0) : 1;
}

CellRect with_rings(const HeightFieldData& field, const CellRect& rect, std::uint32_t rings) {
  const auto before = [&](std::uint32_t first) { return first - std::min(first, rings); };
  const auto after = [&](std::uint32_t last, std::uint32_t end) {
    return last + std::min(end - last, rings);
  };
  return {before(rect.first_column), before(rect.first_row),
          after(rect.last_column, field.cell_columns()), after(rect.last_row, field.cell_rows())};
}

bool has_cell(const HeightFieldData& field, const CellRect& rect) {
  for (std::uint32_t r = rect.first_row; r < rect.last_row; ++r) {
    for (std::uint32_t c = rect.first_column; c < rect.last_column; ++c) {
      if (!field.is_hole(c, r)) return true;
    }
  }
  return false;
}

/// Returns the length of the diagonal of the box around a shape; 0 for a half-space, as all cells
/// before it are near.
double size_of(const PlacedShapeView& shape) {
  if (shape.shape.kind() == ShapeKind::HalfSpace) return 0;
  const Aabb box = bounding_aabb(shape);
  return (box.max - box.min).norm();
}

}  // namespace

Shape square_patch(const HeightFieldData& field, const CellSquare& square, const PatchNeed& need) {
  const CellRect cells = field.cells_of(square);
  return Shape(need.is_kept ? kept_patch_of(field, cells) : patch_of(field, std::span(&cells, 1)));
}

StandIn::StandIn(const PlacedShapeView& field, const PlacedShapeView& other, const FieldNeed& need)
    : shape_(field.shape), pose_(field.pose) {
  const auto* as_field = field.shape.as<HeightField>();
  if (as_field == nullptr) return;
  FieldQuery query(HeightFieldAccess::data(*as_field), field.pose, other);
  query.grow(need.room);
  take(query, {.aside = need.aside > 0 ? need.aside * (size_of(other) + need.room) : 0,
               .rings = need.rings,
               .is_kept = keeps_patches(other)});
}

StandIn::StandIn(const PlacedShapeView& field, const FieldQuery& query, const PatchNeed& need)
    : shape_(field.shape), pose_(field.pose) {
  if (field.shape.kind() == ShapeKind::HeightField) take(query, need);
}

void StandIn::take(const FieldQuery& query, const PatchNeed& need) {
  const HeightFieldData& field = HeightFieldAccess::data(*shape_.as<HeightField>());
  is_near_ = is_any_met(field, query);
  if (!is_near_) {
    CellSquare any = field.root();
    while (any.level > 0) {
      CellSquare below = any;
      field.for_children(any, [&](const CellSquare& child) {
        if (below.level == any.level && !field.range_of(child).is_empty()) below = child;
      });
      any = below;
    }
    mesh_ = square_patch(field, any, need);
    return;
  }
  FieldQuery wide = query;
  CellRect around = query.columns_of_cells(field);
  if (need.aside > 0) {
    // A flat face leads aside by as much as it leans. Neighbours count, too: there is a ring of
    // cells around near ones already. Two meshes are asked piece by piece, and a piece grows:
    // mostly the cells here are enough, and otherwise the question is asked again (ask_contacts()).
    wide.grow_aside(need.aside * (need.is_kept ? steepest_sine(field, around) : 1));
    around = wide.columns_of_cells(field);
  }
  const bool is_whole = around.count() <= (need.aside > 0 ? kMostAtOnce : kFewCells);
  // Rings are added however many there are: a caller who asks for them has met the end of a patch
  // with fewer.
  around = with_rings(field, around, need.rings);
  if (is_whole && has_cell(field, around)) {
    mesh_ =
        Shape(need.is_kept ? kept_patch_of(field, around) : patch_of(field, std::span(&around, 1)));
    return;
  }
  std::vector<CellRect> rects;
  for (const CellSquare& square : squares_met(field, wide))
    rects.push_back(field.cells_of(square));
  mesh_ = Shape(patch_of(field, rects));
}

}  // namespace graze
