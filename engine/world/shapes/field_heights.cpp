#include <graze/engine/world/shapes/field_heights.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

using narrowphase::Vec3;

namespace {

class LowestVertex {
 public:
  LowestVertex(const HeightFieldData& field, const Pose& pose, const PlacedHalfSpace& plane)
      : field_(field), pose_(pose), plane_(plane), origin_(origin_of(pose)) {
    const double size = largest(to_vec3(field.bounds.min)) + largest(to_vec3(field.bounds.max)) +
                        largest(origin_) + std::abs(plane.offset);
    slack_ = 0x1p-40 * size;  // far more than the rounding of a sum of ten such terms
    down(field.root());
  }

  static double height(const Pose& pose, const PlacedHalfSpace& plane,
                       const Eigen::Vector3d& vertex) {
    const Vec3 point = to_vec3(narrowphase::place(pose, vertex)) - origin_of(pose);
    return dot(plane.normal, point) - plane.offset;
  }

  const FieldVertex& found() const { return found_; }

 private:
  static Vec3 origin_of(const Pose& pose) {
    const double* m = pose.data();
    return {m[12], m[13], m[14]};
  }

  double bound(const Aabb& box) const {
    double least = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d point((corner & 1 ? box.max : box.min).x(),
                                  (corner & 2 ? box.max : box.min).y(),
                                  (corner & 4 ? box.max : box.min).z());
      least = std::min(least, height(pose_, plane_, point));
    }
    return least - slack_;
  }

  void down(const CellSquare& square) {
    const CellRect cells = field_.cells_of(square);
    const HeightRange range = field_.range_of(square);
    if (range.is_empty() || !(bound(field_.box_of(cells, range)) < found_.height)) return;
    if (square.level > 0) {
      field_.for_children(square, [&](const CellSquare& child) { down(child); });
      return;
    }
    for (std::uint32_t row = cells.first_row; row < cells.last_row; ++row) {
      for (std::uint32_t column = cells.first_column; column < cells.last_column; ++column) {
        if (!field_.is_hole(column, row)) look_at_cell(column, row);
      }
    }
  }

  void look_at_cell(std::uint32_t column, std::uint32_t row) {
    for (const std::uint32_t corner : {0u, 1u, 2u, 3u}) {
      const std::uint32_t c = column + corner % 2, r = row + corner / 2;
      const double here = height(pose_, plane_, field_.vertex(c, r));
      if (here < found_.height) found_ = {here, c, r};
    }
  }

  const HeightFieldData& field_;
  const Pose& pose_;
  const PlacedHalfSpace& plane_;
  Vec3 origin_;
  double slack_;
  FieldVertex found_{std::numeric_limits<double>::infinity(), 0, 0};
};

}  // namespace

FieldVertex lowest_of(const HeightFieldData& field, const Pose& pose,
                      const PlacedHalfSpace& plane) {
  return LowestVertex(field, pose, plane).found();
}

double height_of(const HeightFieldData& field, const Pose& pose, const PlacedHalfSpace& plane,
                 std::uint32_t column, std::uint32_t row) {
  return LowestVertex::height(pose, plane, field.vertex(column, row));
}

}  // namespace graze
