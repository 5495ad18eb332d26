#pragma once

// Makes stand-ins: meshes that stand for height fields in one question. Private to engine/world.

#include <graze/engine/mesh/data/patch_rim.h>
#include <graze/engine/world/fields/field_query.h>
#include <graze/engine/world/placed_shape.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace graze {

struct Work;

/// Says which part of a field a question may be about.
struct FieldNeed {
  double room = 0;  ///< cells that are so near to the other shape, metres
  /// Cells so far aside from near ones, as multiples of the other's size: they are needed where
  /// neighbours, or what lies flat beyond them, influence the answer.
  double aside = 0;
  std::uint32_t rings = 0;  ///< so many rings of cells around these
};

/// True if a thread may keep patches that it makes for questions about a field and this shape. It
/// may not for meshes, for which wide trees of the patch are built, which must be counted.
inline bool keeps_patches(const PlacedShapeView& other) {
  return other.shape.kind() != ShapeKind::Mesh && other.shape.kind() != ShapeKind::HeightField;
}

/// Says how far aside cells are needed, metres, and whether a patch may be one that is kept.
struct PatchNeed {
  double aside = 0;
  std::uint32_t rings = 0;
  bool is_kept = true;
};

inline bool is_field(const PlacedShapeView& s) {
  return s.shape.kind() == ShapeKind::HeightField;
}
inline bool has_field(const PlacedShapeView& a, const PlacedShapeView& b) {
  return is_field(a) || is_field(b);
}

/// The shape itself, or for a height field a mesh of the cells that are near another shape: for all
/// questions within the need it answers as the field's whole mesh would, bit for bit. If no cell is
/// near, it is one cell that is not.
class StandIn {
 public:
  StandIn(const PlacedShapeView& field, const PlacedShapeView& other, const FieldNeed& need);
  /// Makes a mesh of the cells that the query may come to.
  StandIn(const PlacedShapeView& field, const FieldQuery& query, const PatchNeed& need);

  /// False if no cell is near.
  bool is_near() const { return is_near_; }
  /// Returns the placed stand-in. The shape from which it was made, and the view that
  /// holds it, must outlive it.
  PlacedShapeView view() const { return {mesh_ ? *mesh_ : shape_, pose_}; }
  const Shape& shape() const { return mesh_ ? *mesh_ : shape_; }

 private:
  void take(const FieldQuery& query, const PatchNeed& need);

  const Shape& shape_;
  const Pose& pose_;
  std::optional<Shape> mesh_;
  bool is_near_ = true;
};

/// The stand-ins of both shapes of a pair.
struct StandIns {
  StandIn a, b;

  StandIns(const PlacedShapeView& of_a, const PlacedShapeView& of_b, const FieldNeed& need = {})
      : a(of_a, of_b, need), b(of_b, of_a, need) {}
  bool are_near() const { return a.is_near() && b.is_near(); }
};

/// The aside of contacts: the deepest point of a flat face, and what lies beyond it, may be so far
/// aside.
inline constexpr double kContactAside = 1;

/// Asks for the contacts of a pair with one height field, or two: calls `ask(a, b)` with the
/// stand-ins, and again with more of the field as long as the answer depended on what lies beyond
/// it. It is not called if no cell is near.
template <typename Ask>
void ask_contacts(const PlacedShapeView& a, const PlacedShapeView& b, FieldNeed need,
                  const Ask& ask) {
  for (;; need.rings = 2 * need.rings + 8) {
    const StandIns by(a, b, need);
    if (!by.are_near()) return;
    PatchRim::forget();
    ask(by.a.view(), by.b.view());
    if (!PatchRim::was_met()) return;
  }
}

/// Returns the stand-in for a distance: all cells that may be the nearest. `distance_to(shape)`
/// returns the distance of the other from a mesh that stands for the field.
template <typename DistanceTo>
StandIn nearest_stand_in(const PlacedShapeView& field, const PlacedShapeView& other,
                         const DistanceTo& distance_to);

/// Returns the patch of one square as a shape.
Shape square_patch(const HeightFieldData& field, const CellSquare& square, const PatchNeed& need);

template <typename DistanceTo>
StandIn nearest_stand_in(const PlacedShapeView& field, const PlacedShapeView& other,
                         const DistanceTo& distance_to) {
  const HeightFieldData& data = HeightFieldAccess::data(*field.shape.as<HeightField>());
  FieldQuery query(data, field.pose, other);
  const CellSquare square = nearest_square(data, query);
  // A search that fails may say that the two touch: the distance to the square's box counts as
  // well.
  const double to_box = query.distance(data.box_of(data.cells_of(square), data.range_of(square)));
  const PatchNeed need{.is_kept = keeps_patches(other)};
  query.grow(std::max(distance_to(square_patch(data, square, need)), to_box));
  return StandIn(field, query, need);
}

}  // namespace graze
