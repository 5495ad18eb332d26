#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/element_error.h>
#include <graze/narrowphase/volumes/boxes/batch_sizes.h>
#include <graze/narrowphase/volumes/boxes/obb_kernels.h>
#include <graze/narrowphase/volumes/obb_list.h>
#include <string>

namespace graze {

Obb ObbList::operator[](std::size_t index) const {
  return narrowphase::obb_of(rows_[index]);
}

void ObbList::add(const Obb& box) {
  bvh::in_standard_arithmetic([&] {
    bvh::at_element("box", size(), [&] {
      bvh::check_box(box, ("boxes[" + std::to_string(size()) + "]").c_str());
    });
    rows_.add(narrowphase::row_of(box));
  });
}

void intersects(const Obb& box, const ObbList& boxes, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    const double deviation = bvh::check_box(box, "box");
    narrowphase::check_hits(hits, boxes.size());
    narrowphase::find_overlaps(narrowphase::row_of(box, deviation), boxes.rows_.rows(), hits.size(),
                               hits.data());
  });
}

void intersects(const ObbList& boxes_a, const ObbList& boxes_b, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    narrowphase::check_pairs(boxes_a.size(), boxes_b.size(), "boxes");
    narrowphase::check_hits(hits, boxes_a.size());
    narrowphase::find_overlaps(boxes_a.rows_.rows(), boxes_b.rows_.rows(), hits.size(),
                               hits.data());
  });
}

}  // namespace graze
