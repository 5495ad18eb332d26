#pragma once

// Meshes that stand for height fields in one question. Private to engine/world.

#include <graze/engine/mesh/data/patch_rim.h>
#include <graze/engine/world/fields/field_query.h>
#include <graze/engine/world/placed_shape.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace graze {

struct Work;

/// What of a field a question may be about.
struct FieldNeed {
  double room = 0;  ///< what is so near to the other, metres
  /// Cells so far aside from what is near, too, as multiples of the other's size: those whose
  /// neighbours, or what lies flat beyond them, have a say.
  double aside = 0;
  std::uint32_t rings = 0;  ///< so many rings of cells around these, too
};

/// Whether a thread may keep what it makes for questions about a field and this shape: not for
/// meshes, for which a patch has wide trees made, as somebody must count.
inline bool keeps_patches(const PlacedShapeView& other) {
  return other.shape.kind() != ShapeKind::Mesh && other.shape.kind() != ShapeKind::HeightField;
}

/// Cells so far aside, metres, and whether a patch may be one that is kept.
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

/// The shape itself, or a mesh of the cells of a height field that are near another shape: for all
/// that is asked within the need it says what the field's whole mesh would, bit for bit. If there
/// are none, it is one cell that is not near.
class StandIn {
 public:
  StandIn(const PlacedShapeView& field, const PlacedShapeView& other, const FieldNeed& need);
  /// Of the cells that the query may come to.
  StandIn(const PlacedShapeView& field, const FieldQuery& query, const PatchNeed& need);

  /// False if no cell is near.
  bool is_near() const { return is_near_; }
  /// `shape` is the one that it was made of.
  PlacedShapeView view() const { return {mesh_ ? *mesh_ : shape_, pose_}; }
  const Shape& shape() const { return mesh_ ? *mesh_ : shape_; }

 private:
  void take(const FieldQuery& query, const PatchNeed& need);

  const Shape& shape_;
  const Pose& pose_;
  std::optional<Shape> mesh_;
  bool is_near_ = true;
};

/// Both of a pair.
struct StandIns {
  StandIn a, b;

  StandIns(const PlacedShapeView& of_a, const PlacedShapeView& of_b, const FieldNeed& need = {})
      : a(of_a, of_b, need), b(of_b, of_a, need) {}
  bool are_near() const { return a.is_near() && b.is_near(); }
};

/// For contacts: a flat face may have its deepest point, and what lies beyond it, so far aside.
inline constexpr double kContactAside = 1;

/// Contacts of two of which one is a height field, or both: `ask(a, b)` of what stands for them,
/// again with more of the field as long as it depended on what lies beyond; not called where no
/// cell is near.
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

/// For a distance: all cells that may be the nearest. `distance_to(shape)` is the distance of the
/// other from a mesh that stands for the field.
template <typename DistanceTo>
StandIn nearest_stand_in(const PlacedShapeView& field, const PlacedShapeView& other,
                         const DistanceTo& distance_to);

/// As a shape: the patch of one square.
Shape square_patch(const HeightFieldData& field, const CellSquare& square, const PatchNeed& need);

template <typename DistanceTo>
StandIn nearest_stand_in(const PlacedShapeView& field, const PlacedShapeView& other,
                         const DistanceTo& distance_to) {
  const HeightFieldData& data = HeightFieldAccess::data(*field.shape.as<HeightField>());
  FieldQuery query(data, field.pose, other);
  const CellSquare square = nearest_square(data, query);
  // A search that fails may say that they touch: the square stays.
  const double to_box = query.distance(data.box_of(data.cells_of(square), data.range_of(square)));
  const PatchNeed need{.is_kept = keeps_patches(other)};
  query.grow(std::max(distance_to(square_patch(data, square, need)), to_box));
  return StandIn(field, query, need);
}

}  // namespace graze
