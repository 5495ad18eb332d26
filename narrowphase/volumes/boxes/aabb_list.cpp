#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/element_error.h>
#include <graze/narrowphase/volumes/aabb_list.h>
#include <graze/narrowphase/volumes/boxes/batch_sizes.h>
#include <graze/narrowphase/volumes/boxes/kdop_kernels.h>
#include <array>
#include <string>

namespace graze {
namespace {

std::array<double, 6> row_of(const Aabb& box) {
  const double* min = box.min.data();
  const double* max = box.max.data();
  return {min[0], min[1], min[2], max[0], max[1], max[2]};
}

}  // namespace

Aabb AabbList::operator[](std::size_t index) const {
  const std::array<double, 6> row = rows_[index];
  return {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}};
}

void AabbList::add(const Aabb& box) {
  bvh::in_standard_arithmetic([&] {
    bvh::at_element("box", size(), [&] {
      bvh::check_box(box, ("boxes[" + std::to_string(size()) + "]").c_str());
    });
    rows_.add(row_of(box));
  });
}

AabbArray AabbList::view() const {
  const auto row = [&](std::size_t r) { return std::span(rows_.row(r), size()); };
  return {{row(0), row(1), row(2)}, {row(3), row(4), row(5)}};
}

void intersects(const Aabb& box, const AabbList& boxes, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    bvh::check_box(box, "box");
    narrowphase::check_hits(hits, boxes.size());
    narrowphase::find_overlaps(row_of(box), boxes.rows_.rows(), hits.size(), hits.data());
  });
}

void intersects(const AabbList& boxes_a, const AabbList& boxes_b, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    narrowphase::check_pairs(boxes_a.size(), boxes_b.size(), "boxes");
    narrowphase::check_hits(hits, boxes_a.size());
    narrowphase::find_overlaps(boxes_a.rows_.rows(), boxes_b.rows_.rows(), hits.size(),
                               hits.data());
  });
}

}  // namespace graze
