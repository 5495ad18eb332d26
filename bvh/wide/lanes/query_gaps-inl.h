// How far apart boxes of two wide trees are at least. Included once for each SIMD target.

#if defined(GRAZE_BVH_QUERY_GAPS) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_QUERY_GAPS
#undef GRAZE_BVH_QUERY_GAPS
#else
#define GRAZE_BVH_QUERY_GAPS
#endif

#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// A direction along the axes of a tested node, and the radius of a query box projected on it.
struct Aim {
  float axes[3];
  float size[3];
  float radius;
};

HWY_INLINE Aim aim_of(const WideNode& tested, const QueryInNode& query, const Query& box,
                      const float (&direction)[3]) {
  Aim aim;
  for (int i = 0; i < 3; ++i) {
    aim.axes[i] = tested.axes[0][i] * direction[0] + tested.axes[1][i] * direction[1] +
                  tested.axes[2][i] * direction[2];
    aim.size[i] = std::abs(aim.axes[i]);
  }
  aim.radius = query.half[0] - box.half[0];  // the padding alone
  for (int k = 0; k < 3; ++k) {
    aim.radius +=
        box.half[k] * std::abs(query.axes[k][0] * aim.axes[0] + query.axes[k][1] * aim.axes[1] +
                               query.axes[k][2] * aim.axes[2]);
  }
  return aim;
}

/// What is known of the distances between a query box and the children of a tested node.
struct Promises {
  alignas(32) float bound[WideNode::kWidth];  ///< lower bounds of their squared distances
  alignas(32) float key[WideNode::kWidth];  ///< the order in which to look at them: the least first
};

// Middles tell where bounds do not.
inline constexpr float kMiddleWeight = 0.1f;

// Squares are taken in common units, the larger of both trees': what overflows then is far.
HWY_INLINE Lanes squared_gap(Lanes distance, Lanes radii, Lanes unit) {
  const Lanes gap = hn::Mul(known(Tag(), hn::Sub(hn::Abs(distance), radii)), unit);
  return hn::Mul(gap, gap);
}

/// How the children of a tested node lie from a query box: so many of them as there are lanes.
struct ChildLanes {
  Lanes half[3];
  Lanes offset[3];

  HWY_INLINE ChildLanes(const WideNode& tested, const QueryInNode& query, std::size_t lane) {
    const Tag tag;
    for (int i = 0; i < 3; ++i) {
      half[i] = hn::Load(tag, tested.half[i] + lane);
      offset[i] = hn::Sub(hn::Set(tag, query.offset[i]), hn::Load(tag, tested.centre[i] + lane));
    }
  }
};

// Along the axes of the tested node, the offset between a point of a child's box and one of the
// query box has components that are no less than the gaps between the child's box and the box
// around the query box. The same holds along the axes of the query box, with the roles exchanged.
// Each triple of gaps, squared and summed, is a lower bound of the squared distance.
HWY_INLINE Lanes squared_gaps_in_query(const ChildLanes& child, const QueryInNode& query,
                                       Lanes unit) {
  const Tag tag;
  Lanes sum = hn::Zero(tag);
  for (int k = 0; k < 3; ++k) {
    const Lanes distance =
        hn::MulAdd(child.offset[0], hn::Set(tag, query.axes[k][0]),
                   hn::MulAdd(child.offset[1], hn::Set(tag, query.axes[k][1]),
                              hn::Mul(child.offset[2], hn::Set(tag, query.axes[k][2]))));
    const Lanes radii =
        hn::MulAdd(child.half[0], hn::Set(tag, query.size[k][0]),
                   hn::MulAdd(child.half[1], hn::Set(tag, query.size[k][1]),
                              hn::MulAdd(child.half[2], hn::Set(tag, query.size[k][2]),
                                         hn::Set(tag, query.half[k]))));
    sum = hn::Add(sum, squared_gap(distance, radii, unit));
  }
  return sum;
}

HWY_INLINE Lanes squared_gaps_in_tested(const ChildLanes& child, const QueryInNode& query,
                                        Lanes unit) {
  const Tag tag;
  Lanes sum = hn::Zero(tag);
  for (int i = 0; i < 3; ++i) {
    const Lanes radii = hn::Add(child.half[i], hn::Set(tag, query.radius[i]));
    sum = hn::Add(sum, squared_gap(child.offset[i], radii, unit));
  }
  return sum;
}

HWY_INLINE Lanes squared_gap_along(const ChildLanes& child, const Aim& aim, Lanes unit) {
  const Tag tag;
  Lanes distance = hn::Zero(tag);
  Lanes radii = hn::Set(tag, aim.radius);
  for (int i = 0; i < 3; ++i) {
    distance = hn::MulAdd(child.offset[i], hn::Set(tag, aim.axes[i]), distance);
    radii = hn::MulAdd(child.half[i], hn::Set(tag, aim.size[i]), radii);
  }
  const Lanes gap = hn::Mul(known(tag, hn::Sub(distance, radii)), unit);
  return hn::Mul(gap, gap);
}

HWY_INLINE void set_promise(Promises& promises, std::size_t lane, const ChildLanes& child,
                            Lanes bound, Lanes unit) {
  const Tag tag;
  Lanes middles = hn::Zero(tag);
  for (const Lanes& offset : child.offset) {
    const Lanes step = hn::Mul(offset, unit);
    middles = hn::MulAdd(step, step, middles);
  }
  hn::Store(bound, tag, promises.bound + lane);
  hn::Store(hn::MulAdd(middles, hn::Set(tag, kMiddleWeight), bound), tag, promises.key + lane);
}

/// Sets what boxes and a direction say of all children of the tested node.
HWY_INLINE void set_promises(Promises& promises, const WideNode& tested, const QueryInNode& query,
                             const Aim& aim, float unit_of_tested) {
  const Lanes unit = hn::Set(Tag(), unit_of_tested);
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(Tag())) {
    const ChildLanes child(tested, query, lane);
    const Lanes of_boxes = hn::Max(squared_gaps_in_tested(child, query, unit),
                                   squared_gaps_in_query(child, query, unit));
    set_promise(promises, lane, child, hn::Max(of_boxes, squared_gap_along(child, aim, unit)),
                unit);
  }
}

/// The same where lower bounds are known along axes that both trees share: one of
/// these was the direction when boxes were aligned, and it has turned by less than 3.6 degrees
/// since. Of ten thousand children three were beyond the limit along the direction alone.
HWY_INLINE void set_promises_beside(Promises& promises, const float (&bounds)[WideNode::kWidth],
                                    const WideNode& tested, const QueryInNode& query,
                                    float unit_of_tested) {
  const Tag tag;
  const Lanes unit = hn::Set(tag, unit_of_tested);
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    const ChildLanes child(tested, query, lane);
    const Lanes of_boxes = hn::Max(squared_gaps_in_tested(child, query, unit),
                                   squared_gaps_in_query(child, query, unit));
    set_promise(promises, lane, child, hn::Max(of_boxes, hn::Load(tag, bounds + lane)), unit);
  }
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
