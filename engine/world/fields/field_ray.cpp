#include <graze/bvh/value/ray_slabs.h>
#include <graze/engine/world/fields/field_data.h>
#include <graze/engine/world/fields/field_ray.h>
#include <graze/narrowphase/ray/ray_stages.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace graze {

namespace {

/// Follows one ray, from near to far.
class FieldRay {
 public:
  FieldRay(const HeightFieldData& field, const Pose& pose, const Ray& ray, Work& work)
      : field_(field), pose_(pose), prepared_(ray), work_(work) {
    limit_to(ray.max_distance);
    const double* m = pose.data();  // column-major 4x4
    double origin[3], direction[3], from[3];
    double sizes = 0;
    for (int i = 0; i < 3; ++i) {
      from[i] = ray.origin.data()[i] - m[12 + i];
      sizes += std::abs(from[i]) + std::abs(field.bounds.min.data()[i]) +
               std::abs(field.bounds.max.data()[i]);
    }
    const double* d = prepared_.scaled.component;
    for (int k = 0; k < 3; ++k) {
      origin[k] = (m[4 * k] * from[0] + m[4 * k + 1] * from[1]) + m[4 * k + 2] * from[2];
      direction[k] = (m[4 * k] * d[0] + m[4 * k + 1] * d[1]) + m[4 * k + 2] * d[2];
    }
    slabs_ = bvh::RaySlabs(origin, direction);
    // The pad covers what ray_frame_of() derives: 3 dev and some 256 u of these sizes, and law 1's
    // rounding.
    const double placed = std::abs(m[12]) + std::abs(m[13]) + std::abs(m[14]);
    pad_ = (32 * rotation_deviation(pose) + 0x1p-40) * sizes + 0x1p-46 * placed;
  }

  std::optional<RayHit> first() {
    const CellSquare root = field_.root();
    if (entry_of(field_.cells(), field_.range_of(root)) != bvh::kNever) down(root);
    return first_;
  }

 private:
  struct Child {
    CellSquare square;
    double entry;
  };

  void limit_to(double distance) {
    limit_ = distance / bvh::length_of(prepared_.scaled) * (1 + 0x10p-53) + 0x1p-1050;
  }

  double entry_of(const CellRect& cells, const HeightRange& range) {
    ++work_.volume_tests;
    const Aabb box = field_.box_of(cells, range);
    double low[3], high[3];
    for (int k = 0; k < 3; ++k) {
      low[k] = box.min.data()[k] - pad_;
      high[k] = box.max.data()[k] + pad_;
    }
    const double entry = bvh::entry(slabs_, low, high, limit_);
    work_.volume_rejections += entry == bvh::kNever;
    return entry;
  }

  void down(const CellSquare& square) {
    if (square.level == 0) return split(field_.cells_of(square), field_.range_of(square));
    std::array<Child, 16> children;
    std::size_t count = 0;
    field_.for_children(square, [&](const CellSquare& child) {
      const HeightRange range = field_.range_of(child);
      if (range.is_empty()) return;
      const double entry = entry_of(field_.cells_of(child), range);
      if (entry != bvh::kNever) children[count++] = {child, entry};
    });
    std::sort(children.begin(), children.begin() + count,
              [](const Child& s, const Child& t) { return s.entry < t.entry; });
    for (std::size_t i = 0; i < count; ++i) {
      if (children[i].entry <= limit_) down(children[i].square);
    }
  }

  /// Halves rectangles of cells: below a square only single cells have ranges of heights.
  void split(const CellRect& cells, const HeightRange& range) {
    const std::uint32_t columns = cells.last_column - cells.first_column;
    const std::uint32_t rows = cells.last_row - cells.first_row;
    if (columns == 1 && rows == 1) return ask(cells.first_column, cells.first_row);
    CellRect near = cells, far = cells;
    if (columns >= rows) {
      near.last_column = far.first_column = cells.first_column + columns / 2;
    } else {
      near.last_row = far.first_row = cells.first_row + rows / 2;
    }
    const int axis = columns >= rows ? 0 : 1;
    if (slabs_.inverse[axis] < 0 && !slabs_.is_parallel[axis]) std::swap(near, far);
    for (const CellRect& half : {near, far}) {
      if (entry_of(half, range) != bvh::kNever) split(half, range);
    }
  }

  void ask(std::uint32_t column, std::uint32_t row) {
    if (field_.is_hole(column, row)) return;
    HeightRange range;
    for (std::uint32_t i = 0; i < 4; ++i)
      range.add(field_.stored(column + i % 2, row + i / 2));
    if (entry_of({column, row, column + 1, row + 1}, range) == bvh::kNever) return;
    const std::uint32_t number = field_.triangle_number(column, row);
    ask(number);
    ask(number + 1);
  }

  void ask(std::uint32_t number) {
    ++work_.triangle_tests;
    narrowphase::Stage stage{};
    const auto found =
        narrowphase::cast_ray(narrowphase::place(pose_, field_.triangle(number)), prepared_, stage);
    work_.exact_tests += stage == narrowphase::Stage::Exact;
    if (!found) return;
    const bool is_first = !first_ || found->distance < first_->distance ||
                          (found->distance == first_->distance && number < first_->triangle);
    if (!is_first) return;
    const std::uint32_t cell = number / 2, columns = field_.cell_columns();
    first_ = RayHit{found->distance, found->point, found->normal, number,
                    field_.material(cell % columns, cell / columns)};
    limit_to(found->distance);
  }

  const HeightFieldData& field_;
  const Pose& pose_;
  narrowphase::PreparedRay prepared_;
  Work& work_;
  bvh::RaySlabs slabs_;
  double pad_ = 0;
  double limit_ = 0;
  std::optional<RayHit> first_;
};

}  // namespace

std::optional<RayHit> cast_at_field(const HeightField& field, const Pose& pose, const Ray& ray,
                                    Work& work) {
  return FieldRay(HeightFieldAccess::data(field), pose, ray, work).first();
}

}  // namespace graze
