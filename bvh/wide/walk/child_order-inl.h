// Which children a walk in search of what is near takes, and in which order. Included once for each
// SIMD target.

#if defined(GRAZE_BVH_CHILD_ORDER) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_CHILD_ORDER
#undef GRAZE_BVH_CHILD_ORDER
#else
#define GRAZE_BVH_CHILD_ORDER
#endif

#include <graze/bvh/wide/lanes/pair_lanes-inl.h>
#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Returns which of these lanes have bounds that are not beyond a limit.
HWY_INLINE std::uint32_t not_beyond(std::uint32_t lanes, const float (&bounds)[WideNode::kWidth],
                                    float limit) {
  const Tag tag;
  std::uint32_t beyond = 0;
  for (std::size_t part = 0; part < WideNode::kWidth; part += hn::Lanes(tag)) {
    const auto values = hn::Load(tag, bounds + part);
    beyond |= bits_of(tag, hn::Gt(values, hn::Set(tag, limit))) << part;
  }
  return lanes & ~beyond;
}

/// Some children of a node, the farthest first. No branch depends on which that is: it cannot be
/// foretold.
class ChildOrder {
 public:
  /// Keys are not negative, so that their bits have their order; a NaN has a place, too. The lowest
  /// of these bits, which hardly tell any apart, give way to the number of the child.
  HWY_INLINE ChildOrder(std::uint32_t lanes, const float (&keys)[WideNode::kWidth]) {
    const hn::Rebind<std::uint32_t, Tag> tag;
    for (std::size_t part = 0; part < WideNode::kWidth; part += hn::Lanes(tag)) {
      const auto bits = hn::BitCast(tag, hn::Load(Tag(), keys + part));
      const auto number = hn::Iota(tag, static_cast<std::uint32_t>(part));
      const auto numbered = hn::Or(hn::AndNot(hn::Set(tag, kNumber), bits), number);
      hn::Store(hn::IfThenElseZero(lanes_of(tag, lanes >> part), numbered), tag, numbered_ + part);
    }
  }

  /// Returns the number of the farthest child that is left. It may be called once for each child.
  HWY_INLINE std::uint32_t take_farthest() {
    std::uint32_t last = 0;
    for (const std::uint32_t numbered : numbered_)
      last = std::max(last, numbered);
    const std::uint32_t lane = last & kNumber;
    numbered_[lane] = 0;
    return lane;
  }

 private:
  static constexpr std::uint32_t kNumber = WideNode::kWidth - 1;

  alignas(32) std::uint32_t numbered_[WideNode::kWidth];
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
