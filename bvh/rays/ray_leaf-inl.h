// This tells which primitives of a leaf a ray surely misses, and which it surely meets. It is
// included once for each SIMD target.
//
// Along its main axis z the ray moves by (lean x, lean y) for each unit, so that in the leaned
// coordinates X = (x - o_x) - lean_x (z - o_z), and Y alike, it is at 0 throughout (Woop, Benthin,
// Wald, 2013). The side on which it passes the edge from a to b is the sign of X_a Y_b - Y_a X_b,
// the three of a triangle times one factor: two that differ are a sure miss, three alike a passage.
//
// Bounds. Let B be X of the leaf's corner, e its extents, and E = |B| + e_x + e_z. X as computed is
// off by half a step of the grid along x and z each, by twice the slack, and by rounding: 3 |B| + 5
// e_x + 8 e_z times 2^-24, below 2^-20.9 E. If both X and Y are off by at most r, and N is the
// largest |X| + |Y| of the three corners, an edge's product is off by 2 r N + 2 r^2, and by its own
// rounding, 2^-23 N^2. N being below 2.01 E, that is below 2^-21.9 E N: so the bound is 2 r' (N +
// r'), with 2^-20 E in r', which covers also what it is rounded itself, 5 2^-24 of it. It is not
// below 2^-90, where no underflow counts. s is off by 2 for each unit of z
// (tests/proofs/ray_leaves.gappa).
//
// The place of a sure hit is known better than by the depths of the corners: s = sum w s_c / sum w,
// with the product of the edge across from each corner c as w. If these are off by d, that is off
// by sum d (s_c - s) / sum w: at most three bounds of an edge, divided by the sum of the products,
// times how far apart the corners' depths may be, which `first` and `last` say. Four of them cover
// what that is rounded itself, as depths are off by more than they are rounded.

#if defined(GRAZE_BVH_RAY_LEAF) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_RAY_LEAF
#undef GRAZE_BVH_RAY_LEAF
#else
#define GRAZE_BVH_RAY_LEAF
#endif

#include <graze/bvh/rays/ray_boxes-inl.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Half a step of a leaf's grid, and a little more.
inline constexpr float kHalfStep = 0x1.01p-11f;
inline constexpr float kLeafRounding = 0x1p-20f;
inline constexpr float kExtentShare = kHalfStep + kLeafRounding;
/// The rounding of a sure hit's place between its corners.
inline constexpr float kPlaceRounding = 0x1p-20f;

/// A leaf as a ray sees it.
struct SeenLeaf {
  float base[2];         ///< the leaned coordinates of the least corner
  float step[3];         ///< one step of the grid, of coordinates as they are read
  float leaned_step[2];  ///< one step along z in leaned coordinates
  float bound;           ///< the bound of errors of leaned coordinates
  float along_step;
  float along_least;  ///< s of the least corner, less and plus what it is off by
  float along_most;

  HWY_INLINE SeenLeaf(const RayNode& node, std::uint32_t lane, const RayWalkState& ray) {
    const float* const box = node.box[0] + lane;
    double from[3];
    float extent[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t row = ray.axes->row[i];
      from[i] = static_cast<double>(box[row]) - ray.origin[i];
      extent[i] = box[row + RayNode::kWidth] - box[row];
      step[i] = extent[i] * ray.axes->per_bit[i];
    }
    for (int i = 0; i < 2; ++i) {
      base[i] = static_cast<float>(from[i] - ray.lean[i] * from[2]);
      leaned_step[i] = ray.minus_lean[i] * step[2];
    }
    const float farthest = HWY_MAX(std::abs(base[0]), std::abs(base[1]));
    bound = ray.leaf_slack + kExtentShare * (HWY_MAX(extent[0], extent[1]) + extent[2]) +
            kLeafRounding * farthest;
    const float at = static_cast<float>(from[2] * ray.along);
    along_step = step[2] * ray.float_along;
    const float off = ray.leaf_slack + 2 * kExtentShare * extent[2] + kLeafRounding * std::abs(at);
    along_least = at - off;
    along_most = at + off;
  }
};

/// The answer for the lanes of a leaf's primitives, as bits.
struct LeafAnswer {
  std::uint32_t near;  ///< those that are not surely missed before the limit
  std::uint32_t sure;  ///< those that are surely met before it
};

/// Returns one coordinate of a row of corners, where it is among the bits: at most thirty, of which
/// ten are not 0, so that a float holds it.
HWY_INLINE RayLanes corner_lanes(hn::Vec<hn::Rebind<std::uint32_t, RayTag>> packed,
                                 std::uint32_t mask) {
  const hn::Rebind<std::uint32_t, RayTag> bits;
  const hn::Rebind<std::int32_t, RayTag> signed_bits;
  return hn::ConvertTo(RayTag(), hn::BitCast(signed_bits, hn::And(packed, hn::Set(bits, mask))));
}

using PointLanes = hn::Vec<hn::Rebind<std::uint32_t, RayTag>>;

/// The corners of a leaf, a row for each.
struct CornerRows {
  const std::uint32_t* rows;
  std::uint32_t count;

  HWY_INLINE PointLanes row(std::uint32_t c, std::size_t lane) const {
    return hn::LoadU(hn::Rebind<std::uint32_t, RayTag>(), rows + c * count + lane);
  }
};

/// Returns which point is one corner of each primitive, for all lanes of the tag.
template <typename Tag>
HWY_INLINE hn::Vec<Tag> which_points(Tag tag, std::uint32_t corners) {
  const auto shifts = hn::Mul(hn::Iota(tag, 0), hn::Set(tag, SharedPoints::kBits));
  return hn::And(hn::Shr(hn::Set(tag, corners), shifts), hn::Set(tag, SharedPoints::kMost - 1));
}

/// Returns the points, where eight lanes at once hold eight of them.
template <typename Tag, std::size_t kLanes>
struct PointTable {
  static constexpr Tag kTag{};
  hn::Vec<Tag> first;
  hn::Vec<Tag> others;

  HWY_INLINE explicit PointTable(const std::uint32_t* points)
      : first(hn::LoadU(kTag, points)), others(hn::LoadU(kTag, points + RayTree::kLeafSize)) {}

  HWY_INLINE hn::Vec<Tag> corners(std::uint32_t which) const {
    const auto all = which_points(kTag, which);
    const auto of_eight = hn::IndicesFromVec(kTag, hn::And(all, hn::Set(kTag, 7)));
    const auto is_other = hn::TestBit(all, hn::Set(kTag, 8));
    return hn::IfThenElse(is_other, hn::TableLookupLanes(others, of_eight),
                          hn::TableLookupLanes(first, of_eight));
  }
};

/// Does the same where a register holds all of them.
template <typename Tag>
struct PointTable<Tag, SharedPoints::kMost> {
  static constexpr Tag kTag{};
  static constexpr hn::CappedTag<hn::TFromD<Tag>, SharedPoints::kMost> kAll{};
  hn::Vec<decltype(hn::CappedTag<hn::TFromD<Tag>, SharedPoints::kMost>())> all;

  HWY_INLINE explicit PointTable(const std::uint32_t* points) : all(hn::LoadU(kAll, points)) {}

  HWY_INLINE hn::Vec<Tag> corners(std::uint32_t which) const {
    const auto places = hn::IndicesFromVec(kAll, which_points(kAll, which));
    return hn::LowerHalf(kTag, hn::TableLookupLanes(all, places));
  }
};

/// The corners of a leaf whose primitives share points, where there is a lane for each primitive.
struct SharedCorners {
  using Tag = hn::Rebind<std::uint32_t, RayTag>;
  const SharedPoints& leaf;
  PointTable<Tag, hn::MaxLanes(hn::CappedTag<std::uint32_t, SharedPoints::kMost>())> table;

  HWY_INLINE SharedCorners(const SharedPoints& of, const std::uint32_t* points)
      : leaf(of), table(points) {}

  HWY_INLINE PointLanes row(std::uint32_t c, std::size_t) const {
    return table.corners(leaf.corners(c));
  }
};

/// Answers for as many primitives as there are lanes, from `lane` on.
template <typename Corners>
HWY_INLINE LeafAnswer ask_lanes(const Corners& corners, std::size_t lane, const SeenLeaf& leaf,
                                const RayWalkState& ray, float* least, float* most) {
  const RayTag tag;
  RayLanes x[3], y[3], z[3], size, low, high;
  for (std::uint32_t c = 0; c < 3; ++c) {
    const auto packed = corners.row(c, lane);
    z[c] = corner_lanes(packed, ray.axes->mask[2]);
    x[c] =
        hn::MulAdd(corner_lanes(packed, ray.axes->mask[0]), hn::Set(tag, leaf.step[0]),
                   hn::MulAdd(z[c], hn::Set(tag, leaf.leaned_step[0]), hn::Set(tag, leaf.base[0])));
    y[c] =
        hn::MulAdd(corner_lanes(packed, ray.axes->mask[1]), hn::Set(tag, leaf.step[1]),
                   hn::MulAdd(z[c], hn::Set(tag, leaf.leaned_step[1]), hn::Set(tag, leaf.base[1])));
    const RayLanes its = hn::Add(hn::Abs(x[c]), hn::Abs(y[c]));
    size = c == 0 ? its : hn::Max(size, its);
    low = c == 0 ? z[c] : hn::Min(low, z[c]);
    high = c == 0 ? z[c] : hn::Max(high, z[c]);
  }
  RayLanes edge[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3;
    edge[c] = hn::MulSub(x[c], y[d], hn::Mul(y[c], x[d]));
  }
  const RayLanes bound = hn::Set(tag, leaf.bound);
  const RayLanes off = hn::Mul(hn::Add(size, bound), hn::Add(bound, bound));
  const RayLanes minus_off = hn::Neg(off);
  const RayLanes least_edge = hn::Min(edge[0], hn::Min(edge[1], edge[2]));
  const RayLanes most_edge = hn::Max(edge[0], hn::Max(edge[1], edge[2]));
  const auto is_missed = hn::And(hn::Gt(most_edge, off), hn::Lt(least_edge, minus_off));
  const RayLanes along_step = hn::Set(tag, leaf.along_step);
  const RayLanes at_low = hn::Mul(low, along_step), at_high = hn::Mul(high, along_step);
  const RayLanes first = hn::Add(hn::Min(at_low, at_high), hn::Set(tag, leaf.along_least));
  const RayLanes last = hn::Add(hn::Max(at_low, at_high), hn::Set(tag, leaf.along_most));
  const auto is_near = hn::AndNot(
      is_missed, hn::And(hn::Le(first, hn::Set(tag, ray.limit)), hn::Ge(last, hn::Zero(tag))));
  const std::uint32_t near = ray_bits(is_near);
  if (near == 0) return {0, 0};
  const auto is_passed = hn::Or(hn::Gt(least_edge, off), hn::Lt(most_edge, minus_off));
  const auto is_sure = hn::And(
      is_passed, hn::And(hn::Ge(first, hn::Zero(tag)), hn::Le(last, hn::Set(tag, ray.sure_limit))));
  hn::StoreU(first, tag, least + lane);
  const RayLanes sum = hn::Add(hn::Add(edge[0], edge[1]), edge[2]);
  const RayLanes per_sum = hn::Div(hn::Set(tag, 1.0f), sum);
  const RayLanes weighted =
      hn::MulAdd(edge[0], hn::Sub(z[2], low),
                 hn::MulAdd(edge[1], hn::Sub(z[0], low), hn::Mul(edge[2], hn::Sub(z[1], low))));
  const RayLanes share =
      hn::MulAdd(hn::Mul(hn::Set(tag, 4.0f), off), hn::Abs(per_sum), hn::Set(tag, kPlaceRounding));
  const RayLanes place = hn::MulAdd(weighted, per_sum, low);
  const RayLanes there = hn::MulAdd(place, along_step, hn::Set(tag, leaf.along_most));
  // Where it is not a sure hit this may be anything.
  hn::StoreU(hn::Min(hn::MulAdd(share, hn::Sub(last, first), there), last), tag, most + lane);
  return {near << lane, ray_bits(is_sure) << lane};
}

HWY_INLINE LeafAnswer ask_rows(const CornerRows& corners, std::uint32_t count, const SeenLeaf& leaf,
                               const RayWalkState& ray, float* least, float* most) {
  LeafAnswer answer{0, 0};
  for (std::size_t lane = 0; lane < count; lane += hn::Lanes(RayTag())) {
    const LeafAnswer some = ask_lanes(corners, lane, leaf, ray, least, most);
    answer = {answer.near | some.near, answer.sure | some.sure};
  }
  return answer;
}

HWY_INLINE LeafAnswer among(LeafAnswer answer, std::uint32_t count) {
  const std::uint32_t lanes = (1u << count) - 1;
  return {answer.near & lanes, answer.sure & lanes & answer.near};
}

HWY_INLINE LeafAnswer ask_leaf(const std::uint32_t* corners, std::uint32_t count,
                               const SeenLeaf& leaf, const RayWalkState& ray, float* least,
                               float* most) {
  const CornerRows rows{corners, count};
  if constexpr (hn::MaxLanes(RayTag()) == RayTree::kLeafSize) {
    return among(ask_lanes(rows, 0, leaf, ray, least, most), count);
  } else {
    return among(ask_rows(rows, count, leaf, ray, least, most), count);
  }
}

HWY_INLINE LeafAnswer ask_leaf(const SharedPoints& shared, const std::uint32_t* points,
                               std::uint32_t count, const SeenLeaf& leaf, const RayWalkState& ray,
                               float* least, float* most) {
  if constexpr (hn::MaxLanes(RayTag()) == RayTree::kLeafSize) {
    return among(ask_lanes(SharedCorners(shared, points), 0, leaf, ray, least, most), count);
  } else {
    std::uint32_t rows[3 * RayTree::kLeafSize];
    for (std::uint32_t c = 0; c < 3; ++c) {
      for (std::uint32_t i = 0; i < RayTree::kLeafSize; ++i)
        rows[c * RayTree::kLeafSize + i] = points[shared.corner(i, c)];
    }
    return among(ask_rows({rows, RayTree::kLeafSize}, count, leaf, ray, least, most), count);
  }
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
