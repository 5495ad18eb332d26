#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/element_error.h>
#include <graze/narrowphase/volumes/boxes/batch_sizes.h>
#include <graze/narrowphase/volumes/boxes/kdop_kernels.h>
#include <graze/narrowphase/volumes/kdop_list.h>
#include <algorithm>
#include <array>
#include <string>

namespace graze {
namespace {

std::array<double, 18> row_of(const KDop<18>& kdop) {
  std::array<double, 18> row;
  std::copy(kdop.min.begin(), kdop.min.end(), row.begin());
  std::copy(kdop.max.begin(), kdop.max.end(), row.begin() + KDop<18>::kSlabs);
  return row;
}

}  // namespace

KDop<18> KDopList::operator[](std::size_t index) const {
  const std::array<double, 18> row = rows_[index];
  KDop<18> kdop;
  std::copy(row.begin(), row.begin() + KDop<18>::kSlabs, kdop.min.begin());
  std::copy(row.begin() + KDop<18>::kSlabs, row.end(), kdop.max.begin());
  return kdop;
}

void KDopList::add(const KDop<18>& kdop) {
  bvh::in_standard_arithmetic([&] {
    bvh::at_element("k-DOP", size(), [&] {
      bvh::check_kdop(kdop, ("k-DOPs[" + std::to_string(size()) + "]").c_str());
    });
    rows_.add(row_of(kdop));
  });
}

void intersects(const KDop<18>& kdop, const KDopList& kdops, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    bvh::check_kdop(kdop, "k-DOP");
    narrowphase::check_hits(hits, kdops.size());
    narrowphase::find_overlaps(row_of(kdop), kdops.rows_.rows(), hits.size(), hits.data());
  });
}

void intersects(const KDopList& kdops_a, const KDopList& kdops_b, std::span<std::uint8_t> hits) {
  bvh::in_standard_arithmetic([&] {
    narrowphase::check_pairs(kdops_a.size(), kdops_b.size(), "k-DOPs");
    narrowphase::check_hits(hits, kdops_a.size());
    narrowphase::find_overlaps(kdops_a.rows_.rows(), kdops_b.rows_.rows(), hits.size(),
                               hits.data());
  });
}

}  // namespace graze
