#include <graze/engine/world/fields/field_patch.h>
#include <graze/engine/world/fields/stand_in.h>
#include <graze/engine/world/shape_bounds.h>

#include <algorithm>
#include <vector>

namespace graze {

namespace {

// Rectangles begin and end at multiples of this, so that what moves a little asks for the same.
constexpr std::uint32_t kStep = 4;

// Cells above or below something else are left out of a patch if it would have more than so many.
constexpr std::uint64_t kMostAtOnce = std::uint64_t{1} << 16;

CellRect rounded_out(const CellRect& rect, const CellRect& all) {
  const auto up = [](std::uint32_t at, std::uint32_t most) {
    return std::min(most, (at + kStep - 1) / kStep * kStep);
  };
  return {rect.first_column / kStep * kStep, rect.first_row / kStep * kStep,
          up(rect.last_column, all.last_column), up(rect.last_row, all.last_row)};
}

bool has_cell(const HeightFieldData& field, const CellRect& rect) {
  for (std::uint32_t r = rect.first_row; r < rect.last_row; ++r) {
    for (std::uint32_t c = rect.first_column; c < rect.last_column; ++c) {
      if (!field.is_hole(c, r)) return true;
    }
  }
  return false;
}

/// The longest side of the box around it; of a half-space 0, as all cells before it are near.
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
  FieldReach reach(HeightFieldAccess::data(*as_field), field.pose, other);
  reach.grow(need.room);
  take(reach, {.aside = need.aside > 0 ? need.aside * (size_of(other) + need.room) : 0,
               .is_kept = keeps_patches(other)});
}

StandIn::StandIn(const PlacedShapeView& field, const FieldReach& reach, const PatchNeed& need)
    : shape_(field.shape), pose_(field.pose) {
  if (field.shape.kind() == ShapeKind::HeightField) take(reach, need);
}

void StandIn::take(const FieldReach& reach, const PatchNeed& need) {
  const HeightFieldData& field = HeightFieldAccess::data(*shape_.as<HeightField>());
  is_near_ = is_any_met(field, reach);
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
  FieldReach wide = reach;
  wide.grow_aside(need.aside);
  const CellRect around = rounded_out(wide.columns_of_cells(field), field.cells());
  const bool is_kept = need.is_kept && around.count() <= kMostKeptCells;
  const bool is_whole = around.count() <= (need.aside > 0 ? kMostAtOnce : kMostKeptCells);
  if (is_whole && has_cell(field, around)) {
    mesh_ = Shape(is_kept ? kept_patch_of(field, around) : patch_of(field, std::span(&around, 1)));
    return;
  }
  std::vector<CellRect> rects;
  for (const CellSquare& square : squares_met(field, wide))
    rects.push_back(field.cells_of(square));
  mesh_ = Shape(patch_of(field, rects));
}

}  // namespace graze
