// Which children of a tested node are near a query box.
// Included once for each SIMD target.

#if defined(GRAZE_BVH_NEAR_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_NEAR_LANES
#undef GRAZE_BVH_NEAR_LANES
#else
#define GRAZE_BVH_NEAR_LANES
#endif

#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <graze/bvh/wide/lanes/slab_lanes-inl.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// The bits of the children that the query box is not proved apart from, and how far their middles
/// are from its own, squared.
///
/// This is the separating axis test of two boxes along 15 axes that bvh/value/separating_axes.h
/// derives. The kernel has code of its own because it compares eight boxes at once, in float, with
/// one padding in place of the slack (wide_bounds.h): all that is known of the query box is
/// computed once for the eight, and the nine cross products are left out where six axes tell all of
/// them apart.
template <typename AnyQuery>
HWY_INLINE std::uint32_t near_lanes(const WideNode& tested, const AnyQuery& query,
                                    float* squared_distances) {
  const Tag tag;
  std::uint32_t near = 0;
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    Lanes half[3], offset[3];
    auto apart = hn::Gt(hn::Zero(tag), hn::Zero(tag));
    for (int i = 0; i < 3; ++i) {
      half[i] = hn::Load(tag, tested.half[i] + lane);
      offset[i] = hn::Sub(hn::Set(tag, query.offset(i)), hn::Load(tag, tested.centre[i] + lane));
      apart = hn::Or(apart,
                     hn::Gt(hn::Abs(offset[i]), hn::Add(half[i], hn::Set(tag, query.radius(i)))));
    }
    for (int k = 0; k < 3; ++k) {
      const Lanes distance =
          hn::MulAdd(offset[0], hn::Set(tag, query.axis(k, 0)),
                     hn::MulAdd(offset[1], hn::Set(tag, query.axis(k, 1)),
                                hn::Mul(offset[2], hn::Set(tag, query.axis(k, 2)))));
      const Lanes radii = hn::MulAdd(half[0], hn::Set(tag, query.size(k, 0)),
                                     hn::MulAdd(half[1], hn::Set(tag, query.size(k, 1)),
                                                hn::MulAdd(half[2], hn::Set(tag, query.size(k, 2)),
                                                           hn::Set(tag, query.half(k)))));
      apart = hn::Or(apart, hn::Gt(hn::Abs(distance), radii));
    }
    if (hn::AllTrue(tag, apart)) continue;
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        const Lanes distance = hn::MulSub(offset[i2], hn::Set(tag, query.axis(k, i1)),
                                          hn::Mul(offset[i1], hn::Set(tag, query.axis(k, i2))));
        const Lanes radii = hn::MulAdd(half[i1], hn::Set(tag, query.size(k, i2)),
                                       hn::MulAdd(half[i2], hn::Set(tag, query.size(k, i1)),
                                                  hn::Set(tag, query.cross_radius(k, i))));
        apart = hn::Or(apart, hn::Gt(hn::Abs(distance), radii));
      }
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, hn::Not(apart), bits);
    near |= std::uint32_t{bits[0]} << lane;
    hn::Store(hn::Add(hn::Add(hn::Mul(offset[0], offset[0]), hn::Mul(offset[1], offset[1])),
                      hn::Mul(offset[2], offset[2])),
              tag, squared_distances + lane);
  }
  return near & tested.lanes();
}

/// Those of the children whose slabs do not prove that they are apart from the query box. Not
/// inlined: where nobody asks slabs the walk is faster without all this in its loop.
template <typename AnyQuery>
HWY_NOINLINE std::uint32_t near_slabs(const WideNode& tested, const AnyQuery& query,
                                      const QuerySlab& slab) {
  const Tag tag;
  std::uint32_t near = 0;
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    Lanes half[3], offset[3];
    for (int i = 0; i < 3; ++i) {
      half[i] = hn::Load(tag, tested.half[i] + lane);
      offset[i] = hn::Sub(hn::Set(tag, query.offset(i)), hn::Load(tag, tested.centre[i] + lane));
    }
    const SlabGap gap(SlabLanes(tested, lane, half), offset, query, slab);
    const auto apart = hn::Gt(hn::Abs(gap.distance), gap.radii);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, hn::Not(apart), bits);
    near |= std::uint32_t{bits[0]} << lane;
  }
  return near;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
