// Which primitives of two leaves surely cross, and which are surely apart. Included once for each
// SIMD target.
//
// Whether two triangles meet is decided by signs of determinants of three vectors: edges of the
// two, and offsets between their corners. A sign is sure where the determinant exceeds its error,
// which CrossingErrors computes for each pair of primitives from their own sizes. So small
// primitives beside large ones are told apart as well as others.
//
// Notation. u = 2^-24. In each component an edge of the tested node, from its first corner, is off
// by a, one of the query box by b, and the offset between the first corners by d, which is no less
// than either (front/local_leaves-inl.h, walk/pair_batch-inl.h). S is the sum of the 1-norms of
// both edges of the tested node, T that of the query box, V bounds the offset to any corner of the
// query box; all three are increased by what they may be off by. A determinant is a sum of six
// products of one component each, which add up to no more than the product of the three 1-norms.
// Its error is found by replacing one vector after the other.
//
// Why the signs hold for placed primitives. The frame of a tested node is the common one, turned by
// the transpose of a pose. The determinant of a pose is positive, so that turning changes no sign.
// The frame's corners are not exactly the placed ones, but d includes law 5's slack, which bounds
// how far apart the two are.
//
// Where primitives are apart, a direction says so, along which a front keeps the gap. The normal of
// a plane that has the other primitive on one side is such a direction. So is the cross product of
// the two edges that bound a gap between segments (CutSegments): the line that both planes share
// meets the plane through one edge and along the other at an end of its own segment, so that this
// segment, and with it the primitive, is on one side of that plane.

#if defined(GRAZE_BVH_LEAF_CROSSINGS) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_LEAF_CROSSINGS
#undef GRAZE_BVH_LEAF_CROSSINGS
#else
#define GRAZE_BVH_LEAF_CROSSINGS
#endif

#include <graze/bvh/wide/lanes/pair_lanes-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// What a determinant rounds by, of the product of the 1-norms of its vectors: 6 u at most, for
/// which 16 u are taken.
inline constexpr float kSignRounding = 0x1p-20f;

/// Heights over the tested node's plane change by a S V + d S^2 / 2 at most: edges make a normal of
/// S^2 / 4 at most, and an offset to a corner is off by b + d. kOffsetError is the factor of the
/// first term, with what V and S round by; that of the second is 1 in place of 1 / 2.
inline constexpr float kOffsetError = 1.125f;

/// Of an edge of each primitive and the offset between two corners, of length L, the determinant
/// changes by
///   2.44 (a T + b S) (L + 10.4 d) + (3.44 d + u L) S T.
/// An edge is off by 2.44 a or 2.44 b with what rounds where it is a difference of two, the offset
/// by 3.44 d + u L. kEdgeError is the factor of (a T + b S) L. kEdgesError d S T covers all that
/// has the factor d, for a T + b S is S T / 6 at most, because S and T include what they may be off
/// by.
inline constexpr float kEdgeError = 2.5f;
inline constexpr float kEdgesError = 8;

/// A cross product of edges is off by 3.3 (a T + b S) in each component as it is computed. Along it
/// both primitives together extend further by 3.3 (a T + b S) (S + T).
inline constexpr float kExtentError = 3.5f;

template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> dot(AnyTag, const hn::Vec<AnyTag> (&a)[3],
                               const hn::Vec<AnyTag> (&b)[3]) {
  return hn::MulAdd(a[0], b[0], hn::MulAdd(a[1], b[1], hn::Mul(a[2], b[2])));
}

template <typename AnyTag>
HWY_INLINE void set_cross(AnyTag, const hn::Vec<AnyTag> (&a)[3], const hn::Vec<AnyTag> (&b)[3],
                          hn::Vec<AnyTag> (&product)[3]) {
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3;
    const int i2 = (i + 2) % 3;
    product[i] = hn::MulSub(a[i1], b[i2], hn::Mul(a[i2], b[i1]));
  }
}

template <typename AnyTag>
HWY_INLINE hn::Vec<AnyTag> one_norm(AnyTag, const hn::Vec<AnyTag> (&v)[3]) {
  return hn::Add(hn::Add(hn::Abs(v[0]), hn::Abs(v[1])), hn::Abs(v[2]));
}

/// Pairs of primitives, one in each lane: edges from first corners to the others, and where the
/// first corners lie.
template <typename AnyTag>
struct PairEdges {
  hn::Vec<AnyTag> tested[2][3];
  hn::Vec<AnyTag> query[2][3];
  hn::Vec<AnyTag> offset[3];  ///< from the tested primitive's first corner to the other's
};

/// How far each component of these is off; infinite where products could overflow.
template <typename AnyTag>
struct PairErrors {
  hn::Vec<AnyTag> tested;
  hn::Vec<AnyTag> query;
  hn::Vec<AnyTag> offset;  ///< no less than both
};

/// How far determinants can be off.
template <typename AnyTag>
class CrossingErrors {
 public:
  using Values = hn::Vec<AnyTag>;

  HWY_INLINE CrossingErrors(const PairEdges<AnyTag>& pairs, const PairErrors<AnyTag>& errors)
      : errors_(errors),
        tested_(size(pairs.tested, errors.tested)),
        query_(size(pairs.query, errors.query)),
        offset_(
            hn::MulAdd(errors.offset, hn::Set(AnyTag(), 6.0f), one_norm(AnyTag(), pairs.offset))),
        off_(hn::MulAdd(tested_, errors.query, hn::Mul(query_, errors.tested))) {}

  /// Of two edges of the tested primitive and an offset to the other one.
  HWY_INLINE Values of_tested_plane() const {
    return of_plane(tested_, hn::Add(offset_, query_), errors_.tested);
  }
  HWY_INLINE Values of_query_plane() const {
    return of_plane(query_, hn::Add(offset_, tested_), errors_.query);
  }

  /// Of an edge of each primitive and this offset.
  HWY_INLINE Values of_cuts(const Values (&offset)[3]) const {
    const AnyTag tag;
    const auto length = one_norm(tag, offset);
    const auto each = hn::MulAdd(length, hn::Set(tag, kSignRounding),
                                 hn::Mul(errors_.offset, hn::Set(tag, kEdgesError)));
    return hn::MulAdd(
        hn::Mul(tested_, query_), each,
        hn::MulAdd(hn::Mul(off_, length), hn::Set(tag, kEdgeError), hn::Set(tag, kWideUnderflow)));
  }

  /// How much closer than the heights of cuts both primitives may be along that cross product.
  HWY_INLINE Values of_sides() const {
    return hn::Mul(hn::Mul(off_, hn::Add(tested_, query_)), hn::Set(AnyTag(), kExtentError));
  }

 private:
  HWY_INLINE static Values size(const Values (&edges)[2][3], Values error) {
    const AnyTag tag;
    return hn::MulAdd(error, hn::Set(tag, 12.0f),
                      hn::Add(one_norm(tag, edges[0]), one_norm(tag, edges[1])));
  }

  HWY_INLINE Values of_plane(Values size, Values offset, Values error) const {
    const AnyTag tag;
    const auto each = hn::MulAdd(offset, hn::Set(tag, 0.25f * kSignRounding), errors_.offset);
    return hn::MulAdd(hn::Mul(size, size), each,
                      hn::MulAdd(hn::Mul(size, offset), hn::Mul(error, hn::Set(tag, kOffsetError)),
                                 hn::Set(tag, kWideUnderflow)));
  }

  PairErrors<AnyTag> errors_;
  Values tested_;
  Values query_;
  Values offset_;
  Values off_;  ///< the error of a cross product of two edges, one of each primitive
};

/// The signs of three corners beside a plane.
template <typename AnyTag>
struct SidesOfPlane {
  using Values = hn::Vec<AnyTag>;

  hn::Mask<AnyTag> is_negative[3];
  hn::Mask<AnyTag> is_sure;  ///< whether all three signs are sure
  Values beyond;             ///< how far the nearest corner is from the plane, times the normal

  /// From the height of the first corner, and the edges from there to the others.
  HWY_INLINE SidesOfPlane(const Values (&normal)[3], Values height, const Values (&edges)[2][3],
                          Values bound) {
    const AnyTag tag;
    auto least = hn::Abs(height);
    is_negative[0] = hn::Lt(height, hn::Zero(tag));
    for (int c = 1; c < 3; ++c) {
      const auto other = hn::Add(height, dot(tag, normal, edges[c - 1]));
      least = hn::Min(least, hn::Abs(other));
      is_negative[c] = hn::Lt(other, hn::Zero(tag));
    }
    beyond = hn::Sub(least, bound);
    is_sure = hn::Gt(beyond, hn::Zero(tag));
  }

  HWY_INLINE hn::Mask<AnyTag> are_equal() const {
    return hn::Not(
        hn::Or(hn::Xor(is_negative[0], is_negative[1]), hn::Xor(is_negative[0], is_negative[2])));
  }
};

/// A primitive seen from its apex, the corner that is alone on its side of the other's plane: where
/// the apex lies from the first corner, and the edges from there to the next corner and to the
/// last, which may be stored reversed.
template <typename AnyTag>
struct FromApex {
  using Values = hn::Vec<AnyTag>;

  Values corner[3];
  Values next[3];
  Values last[3];
  hn::Mask<AnyTag> is_next_reversed;
  hn::Mask<AnyTag> is_last_reversed;
  hn::Mask<AnyTag> is_negative;

  HWY_INLINE FromApex(const Values (&edges)[2][3], const SidesOfPlane<AnyTag>& sides) {
    const auto is_first = hn::Not(hn::Xor(sides.is_negative[1], sides.is_negative[2]));
    const auto is_second = hn::Not(hn::Xor(sides.is_negative[0], sides.is_negative[2]));
    is_negative =
        hn::Xor(hn::Xor(sides.is_negative[0], sides.is_negative[1]), sides.is_negative[2]);
    is_next_reversed = hn::Not(hn::Or(is_first, is_second));
    is_last_reversed = hn::Not(is_first);
    for (int i = 0; i < 3; ++i) {
      const auto& to_second = edges[0][i];
      const auto& to_third = edges[1][i];
      const auto between = hn::Sub(to_third, to_second);
      corner[i] = hn::IfThenZeroElse(is_first, hn::IfThenElse(is_second, to_second, to_third));
      next[i] = hn::IfThenElse(is_first, to_second, hn::IfThenElse(is_second, between, to_third));
      last[i] = hn::IfThenElse(is_first, to_third, hn::IfThenElse(is_second, to_second, between));
    }
  }
};

/// Of pairs of which each straddles the other's plane: whether the segments that their planes cut
/// out of them overlap, along the line that the planes share, or leave a gap there. Two pairs of
/// edges bound what is between the segments, and if there is a gap, the primitives are on either
/// side of it along the cross product of such a pair.
template <typename AnyTag>
struct CutSegments {
  using Values = hn::Vec<AnyTag>;
  using Masks = hn::Mask<AnyTag>;

  Values across[2][3];  ///< cross products of edges
  Values height[2];     ///< of the query's primitive beyond the tested one along these
  Values gap[2];        ///< the height on the side on which a gap would be, less its error
  Masks do_overlap;

  HWY_INLINE CutSegments(const FromApex<AnyTag>& s, const FromApex<AnyTag>& t,
                         const Values (&first_offset)[3], const CrossingErrors<AnyTag>& errors) {
    const AnyTag tag;
    const Masks is_crossed = hn::Xor(s.is_negative, t.is_negative);
    Values offset[3], with_next[3], with_last[3];
    for (int i = 0; i < 3; ++i) {
      offset[i] = hn::Add(first_offset[i], hn::Sub(t.corner[i], s.corner[i]));
      with_next[i] = hn::IfThenElse(is_crossed, t.last[i], t.next[i]);
      with_last[i] = hn::IfThenElse(is_crossed, t.next[i], t.last[i]);
    }
    set_cross(tag, s.next, with_next, across[0]);
    set_cross(tag, s.last, with_last, across[1]);
    const auto select = [&](Masks one, Masks other) HWY_ATTR {
      return hn::Or(hn::And(is_crossed, one), hn::AndNot(is_crossed, other));
    };
    const Masks is_back[2] = {hn::Xor(hn::Xor(s.is_next_reversed, t.is_negative),
                                      select(t.is_last_reversed, t.is_next_reversed)),
                              hn::Not(hn::Xor(hn::Xor(s.is_last_reversed, t.is_negative),
                                              select(t.is_next_reversed, t.is_last_reversed)))};
    const Values bound = errors.of_cuts(offset);
    auto most = hn::Set(tag, -std::numeric_limits<float>::infinity());
    for (int k = 0; k < 2; ++k) {
      height[k] = dot(tag, across[k], offset);
      const auto place = hn::IfThenElse(is_back[k], height[k], hn::Neg(height[k]));
      most = hn::Max(most, place);
      gap[k] = hn::Sub(place, bound);
    }
    do_overlap = hn::Lt(most, hn::Neg(bound));
  }

  HWY_INLINE Masks are_apart() const { return hn::Gt(hn::Max(gap[0], gap[1]), hn::Zero(AnyTag())); }
};

/// The boxes of pairs along the axes of the tested node's tree.
template <typename AnyTag>
HWY_INLINE hn::Mask<AnyTag> are_boxes_apart(const PairEdges<AnyTag>& pairs, hn::Vec<AnyTag> error) {
  const AnyTag tag;
  auto most = hn::Zero(tag);
  for (int i = 0; i < 3; ++i) {
    const auto& p = pairs.tested;
    const auto& q = pairs.query;
    const auto zero = hn::Zero(tag);
    const auto tested_low = hn::Min(hn::Min(p[0][i], p[1][i]), zero);
    const auto tested_high = hn::Max(hn::Max(p[0][i], p[1][i]), zero);
    const auto low = hn::Min(hn::Min(q[0][i], q[1][i]), zero);
    const auto high = hn::Max(hn::Max(q[0][i], q[1][i]), zero);
    const auto above = hn::Add(hn::Sub(low, tested_high), pairs.offset[i]);
    const auto below = hn::Sub(hn::Sub(tested_low, high), pairs.offset[i]);
    most = hn::Max(most, hn::Max(above, below));
  }
  return hn::Gt(most, hn::Mul(error, hn::Set(tag, 4.0f)));
}

template <typename AnyTag>
struct PairNormals {
  hn::Vec<AnyTag> tested[3];
  hn::Vec<AnyTag> query[3];

  HWY_INLINE explicit PairNormals(const PairEdges<AnyTag>& pairs) {
    set_cross(AnyTag(), pairs.tested[0], pairs.tested[1], tested);
    set_cross(AnyTag(), pairs.query[0], pairs.query[1], query);
  }
};

/// What is known of some pairs of two leaves, whose corners are off by `errors`; lanes that hold no
/// pair may say anything.
template <typename AnyTag>
struct LeafCrossings {
  using Values = hn::Vec<AnyTag>;
  using Masks = hn::Mask<AnyTag>;

  CrossingErrors<AnyTag> errors;
  PairNormals<AnyTag> normals;
  SidesOfPlane<AnyTag> query_sides;
  SidesOfPlane<AnyTag> tested_sides;
  CutSegments<AnyTag> cuts;
  Masks is_query_beyond;   ///< the query's primitive is on one side of the other's plane
  Masks is_tested_beyond;  ///< the tested primitive is
  Masks is_cut;            ///< each is cut by the other's plane
  Masks are_apart;
  Masks do_cross;

  HWY_INLINE LeafCrossings(const PairEdges<AnyTag>& pairs, const PairErrors<AnyTag>& off)
      : errors(pairs, off),
        normals(pairs),
        query_sides(normals.tested, dot(AnyTag(), normals.tested, pairs.offset), pairs.query,
                    errors.of_tested_plane()),
        tested_sides(normals.query, hn::Neg(dot(AnyTag(), normals.query, pairs.offset)),
                     pairs.tested, errors.of_query_plane()),
        cuts(FromApex<AnyTag>(pairs.tested, tested_sides),
             FromApex<AnyTag>(pairs.query, query_sides), pairs.offset, errors) {
    const AnyTag tag;
    is_query_beyond = hn::And(query_sides.is_sure, query_sides.are_equal());
    is_tested_beyond = hn::And(tested_sides.is_sure, tested_sides.are_equal());
    const Masks are_beyond = hn::Or(is_query_beyond, is_tested_beyond);
    is_cut = hn::AndNot(are_beyond, hn::And(query_sides.is_sure, tested_sides.is_sure));
    are_apart = hn::Or(are_beyond, hn::And(is_cut, cuts.are_apart()));
    do_cross = hn::And(is_cut, cuts.do_overlap);
    const auto is_decided = hn::Or(are_apart, do_cross);
    if (!hn::AllTrue(tag, is_decided))
      are_apart = hn::Or(are_apart, hn::AndNot(is_decided, are_boxes_apart(pairs, off.offset)));
  }
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
