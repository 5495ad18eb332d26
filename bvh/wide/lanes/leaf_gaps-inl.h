// How far apart the primitives of two leaves are at least, and at most. Included once for each SIMD
// target.

#if defined(GRAZE_BVH_LEAF_GAPS) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_LEAF_GAPS
#undef GRAZE_BVH_LEAF_GAPS
#else
#define GRAZE_BVH_LEAF_GAPS
#endif

#include <graze/bvh/wide/lanes/pair_lanes-inl.h>
#include <graze/bvh/wide/lanes/query_gaps-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// How far three corners are beyond the plane with this normal, at least, if they are on one side
/// of it.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> beyond_plane(const Heights<AnyTag>& heights,
                                        const hn::Vec<AnyTag> (&normal)[3], hn::Vec<AnyTag> bound) {
  const AnyTag tag;
  const auto gap = known(tag, hn::Sub(hn::Max(heights.low, hn::Neg(heights.high)), bound));
  const auto square = hn::MulAdd(normal[0], normal[0],
                                 hn::MulAdd(normal[1], normal[1], hn::Mul(normal[2], normal[2])));
  // No plane, no gap: a normal that vanishes is shorter than what is added.
  return hn::Div(gap, hn::Sqrt(hn::Add(square, hn::Set(tag, kWideUnderflow))));
}

/// Holds the interval that each primitive of a leaf takes up along a direction.
struct LeafAlong {
  alignas(16) float start[4];
  alignas(16) float end[4];

  HWY_INLINE void set(const LeafLanes& leaf, const float (&direction)[3]) {
    const FourTag tag;
    for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
      Four least, most;
      for (int c = 0; c < 3; ++c) {
        const auto at = [&](int i) HWY_ATTR { return hn::Load(tag, leaf.corner[c][i] + part); };
        const Four along = hn::MulAdd(at(0), hn::Set(tag, direction[0]),
                                      hn::MulAdd(at(1), hn::Set(tag, direction[1]),
                                                 hn::Mul(at(2), hn::Set(tag, direction[2]))));
        least = c == 0 ? along : hn::Min(least, along);
        most = c == 0 ? along : hn::Max(most, along);
      }
      hn::Store(least, tag, start + part);
      hn::Store(most, tag, end + part);
    }
  }
};

/// Lower bounds of the squared distances of pairs along a direction from the tested primitives to
/// the query's.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> squared_gaps_along(AnyTag tag, const PairLanes<AnyTag>& lanes,
                                              const LeafAlong& tested, const LeafAlong& query,
                                              float leaf_error, float unit_of_tested) {
  // Along a unit vector an error in each of three coordinates counts 1.74 times, that of the
  // products once more.
  const auto gap = hn::Sub(hn::Sub(lanes.query(query.start), lanes.tested(tested.end)),
                           hn::Set(tag, 4 * leaf_error));
  const auto step = hn::Mul(known(tag, gap), hn::Set(tag, unit_of_tested));
  return hn::Mul(step, step);
}

/// The same by boxes along the axes of the tested node's tree.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> squared_box_gaps(AnyTag tag, const PairBoxes<AnyTag>& boxes,
                                            float leaf_error, float unit_of_tested) {
  const auto unit = hn::Set(tag, unit_of_tested);
  const auto error = hn::Set(tag, leaf_error);
  auto of_boxes = hn::Zero(tag);
  for (int i = 0; i < 3; ++i) {
    const auto step = hn::Mul(known(tag, hn::Sub(boxes.gap[i], error)), unit);
    of_boxes = hn::MulAdd(step, step, of_boxes);
  }
  return of_boxes;
}

/// The same by the planes of both.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> squared_plane_gaps(AnyTag tag, const PairBoxes<AnyTag>& boxes,
                                              const PairTriangles<AnyTag>& triangles,
                                              float leaf_error, float unit_of_tested) {
  const auto& tested = triangles.tested;
  const auto& query = triangles.query;
  const auto bound = height_error(tag, boxes.extent, hn::Set(tag, leaf_error));
  const auto of_query = beyond_plane(Heights<AnyTag>(tested, query), tested.normal, bound);
  const auto of_tested = beyond_plane(Heights<AnyTag>(query, tested), query.normal, bound);
  const auto step = hn::Mul(hn::Max(of_tested, of_query), hn::Set(tag, unit_of_tested));
  return hn::Mul(step, step);
}

/// The squared distances of the nearest corners of pairs.
template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> squared_corners(AnyTag tag, const PairTriangles<AnyTag>& triangles) {
  auto least = hn::Set(tag, std::numeric_limits<float>::infinity());
  for (const auto& p : triangles.tested.corner) {
    for (const auto& q : triangles.query.corner) {
      const auto x = hn::Sub(q[0], p[0]);
      const auto y = hn::Sub(q[1], p[1]);
      const auto z = hn::Sub(q[2], p[2]);
      least = hn::Min(least, hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z))));
    }
  }
  return least;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
