// These find the pairs of two clusters for each SIMD target that the compiler knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/clusters/cluster_pairs_kernel.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/clusters/cluster_pairs.h>
#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using ClusterTag = hn::CappedTag<float, Cluster::kWidth>;
using LabelTag = hn::RebindToUnsigned<ClusterTag>;

template <typename Tag, typename Mask>
HWY_INLINE std::uint64_t cluster_bits(Tag tag, Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(tag, mask, bits);
  return bits[0];
}

/// Returns the lanes of `b`, from `first` on, whose boxes overlap that of lane `i` of `a`.
HWY_INLINE auto overlapping_lanes(const Cluster& a, std::uint32_t i, const Cluster& b,
                                  std::size_t first) {
  const ClusterTag tag;
  const auto along = [&](std::size_t k) HWY_ATTR {
    return hn::And(hn::Le(hn::Set(tag, a.box[2 * k][i]), hn::Load(tag, b.box[2 * k + 1] + first)),
                   hn::Le(hn::Load(tag, b.box[2 * k] + first), hn::Set(tag, a.box[2 * k + 1][i])));
  };
  return hn::And(along(0), hn::And(along(1), along(2)));
}

HWY_INLINE auto sharing_lanes(const Cluster& a, std::uint32_t i, const Cluster& b,
                              std::size_t first) {
  const LabelTag tag;
  const auto rows_equal = [&](std::size_t k) HWY_ATTR {
    const auto label = hn::Set(tag, a.label[k][i]);
    return hn::Or(hn::Eq(label, hn::Load(tag, b.label[0] + first)),
                  hn::Or(hn::Eq(label, hn::Load(tag, b.label[1] + first)),
                         hn::Eq(label, hn::Load(tag, b.label[2] + first))));
  };
  return hn::Or(rows_equal(0), hn::Or(rows_equal(1), rows_equal(2)));
}

ClusterPairs pairs_of(const Cluster& a, const Cluster& b) {
  ClusterPairs pairs;
  for (std::uint32_t i = 0; i < a.count; ++i) {
    for (std::size_t first = 0; first < Cluster::kWidth; first += hn::Lanes(ClusterTag())) {
      const std::size_t bit = Cluster::kWidth * i + first;
      pairs.overlapping |= cluster_bits(ClusterTag(), overlapping_lanes(a, i, b, first)) << bit;
      pairs.sharing |= cluster_bits(LabelTag(), sharing_lanes(a, i, b, first)) << bit;
    }
  }
  pairs.sharing &= pairs.overlapping;
  return pairs;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(pairs_of);

namespace {

/// The bits of each lane that stand for the lanes behind it.
constexpr std::uint64_t kBehind = [] {
  std::uint64_t bits = 0;
  for (std::uint32_t i = 0; i < Cluster::kWidth; ++i)
    bits |= std::uint64_t{0xfeu << i & 0xffu} << (Cluster::kWidth * i);
  return bits;
}();

}  // namespace

ClusterPairs pairs_of(const Cluster& a, const Cluster& b) {
  return HWY_DYNAMIC_DISPATCH(pairs_of)(a, b);
}

ClusterPairs pairs_within(const Cluster& cluster) {
  ClusterPairs pairs = pairs_of(cluster, cluster);
  pairs.overlapping &= kBehind;
  pairs.sharing &= kBehind;
  return pairs;
}

}  // namespace graze::bvh
#endif
