// How far apart pairs of primitives are along the direction between their nearest points. Included
// once for each SIMD target.

#if defined(GRAZE_BVH_NEAREST_DIRECTION) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_NEAREST_DIRECTION
#undef GRAZE_BVH_NEAREST_DIRECTION
#else
#define GRAZE_BVH_NEAREST_DIRECTION
#endif

#include <graze/bvh/wide/lanes/leaf_gaps-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Pairs of primitives, one in each lane: all that two leaves can form.
struct NearPairs {
  static constexpr std::size_t kMost = 16;

  alignas(64) float tested[3][3][kMost] = {};  ///< [corner][component]
  alignas(64) float query[3][3][kMost] = {};
  std::uint32_t count = 0;

  void add(const LeafLanes& of_tested, std::uint32_t i_tested, const LeafLanes& of_query,
           std::uint32_t i_query) {
    for (int c = 0; c < 3; ++c) {
      for (int i = 0; i < 3; ++i) {
        tested[c][i][count] = of_tested.corner[c][i][i_tested];
        query[c][i][count] = of_query.corner[c][i][i_query];
      }
    }
    ++count;
  }
};

using ManyTag = hn::CappedTag<float, NearPairs::kMost>;
using Many = hn::Vec<ManyTag>;

/// A vector in each lane.
struct Vectors {
  Many x, y, z;
};

HWY_INLINE Vectors minus(const Vectors& v, const Vectors& w) {
  return {hn::Sub(v.x, w.x), hn::Sub(v.y, w.y), hn::Sub(v.z, w.z)};
}

HWY_INLINE Many dot(const Vectors& v, const Vectors& w) {
  return hn::MulAdd(v.x, w.x, hn::MulAdd(v.y, w.y, hn::Mul(v.z, w.z)));
}

HWY_INLINE Vectors cross(const Vectors& v, const Vectors& w) {
  return {hn::MulSub(v.y, w.z, hn::Mul(v.z, w.y)), hn::MulSub(v.z, w.x, hn::Mul(v.x, w.z)),
          hn::MulSub(v.x, w.y, hn::Mul(v.y, w.x))};
}

/// s v + w
HWY_INLINE Vectors along(Many s, const Vectors& v, const Vectors& w) {
  return {hn::MulAdd(s, v.x, w.x), hn::MulAdd(s, v.y, w.y), hn::MulAdd(s, v.z, w.z)};
}

HWY_INLINE Many share(Many x) {
  const ManyTag tag;
  return hn::Min(hn::Max(x, hn::Zero(tag)), hn::Set(tag, 1.0f));
}

/// 1 / x, and 0 where nothing is to be divided by.
HWY_INLINE Many inverse(Many x) {
  const ManyTag tag;
  return hn::IfThenElseZero(hn::Gt(x, hn::Zero(tag)), hn::Div(hn::Set(tag, 1.0f), x));
}

HWY_INLINE Vectors corner_in(const float (&corner)[3][NearPairs::kMost], std::size_t part) {
  const ManyTag tag;
  return {hn::Load(tag, corner[0] + part), hn::Load(tag, corner[1] + part),
          hn::Load(tag, corner[2] + part)};
}

/// The edges of a triangle, each from the corner with its number.
struct TriangleEdges {
  Vectors edge[3];
  Many square[3];
  Many inverse_square[3];

  HWY_INLINE TriangleEdges(const Vectors& p0, const Vectors& p1, const Vectors& p2) {
    edge[0] = minus(p1, p0);
    edge[1] = minus(p2, p1);
    edge[2] = minus(p0, p2);
    for (int i = 0; i < 3; ++i) {
      square[i] = dot(edge[i], edge[i]);
      inverse_square[i] = inverse(square[i]);
    }
  }
};

/// The shortest offset found so far from a tested primitive to the query's primitive.
struct Shortest {
  Many square;
  Vectors offset;

  HWY_INLINE Shortest() {
    const ManyTag tag;
    square = hn::Set(tag, std::numeric_limits<float>::infinity());
    offset = {hn::Zero(tag), hn::Zero(tag), hn::Zero(tag)};
  }

  template <typename Mask>
  HWY_INLINE void consider_where(Mask mask, const Vectors& other, Many other_square) {
    const auto is_less = hn::And(mask, hn::Lt(other_square, square));
    square = hn::IfThenElse(is_less, other_square, square);
    offset.x = hn::IfThenElse(is_less, other.x, offset.x);
    offset.y = hn::IfThenElse(is_less, other.y, offset.y);
    offset.z = hn::IfThenElse(is_less, other.z, offset.z);
  }
};

/// Two edges, the query box's begins `between` from the tested node's: the nearest points of their
/// lines, then of what is left of them (Ericson, Real-Time Collision Detection, 5.1.9).
HWY_INLINE void consider_edges(Shortest& shortest, const TriangleEdges& tested, int i,
                               const TriangleEdges& query, int j, const Vectors& between) {
  const ManyTag tag;
  const Many b = dot(tested.edge[i], query.edge[j]);
  const Many c = dot(tested.edge[i], between);
  const Many f = dot(query.edge[j], between);
  const Many determinant = hn::MulSub(tested.square[i], query.square[j], hn::Mul(b, b));
  const Many s =
      share(hn::Mul(hn::MulSub(c, query.square[j], hn::Mul(b, f)), inverse(determinant)));
  const Many t = share(hn::Mul(hn::MulSub(b, s, f), query.inverse_square[j]));
  const Many s_of_t = share(hn::Mul(hn::MulAdd(b, t, c), tested.inverse_square[i]));
  const Vectors offset = along(hn::Neg(s_of_t), tested.edge[i], along(t, query.edge[j], between));
  const Many square = dot(offset, offset);
  shortest.consider_where(hn::Ge(square, hn::Zero(tag)), offset, square);
}

/// A triangle, for the corners of the other.
struct Face {
  Vectors inward[3];  ///< across each edge

  HWY_INLINE Face(const TriangleEdges& triangle, const Vectors& normal) {
    for (int k = 0; k < 3; ++k)
      inward[k] = cross(normal, triangle.edge[k]);
  }
};

/// A corner above or below a triangle; `to_corner` leads there from each corner of the triangle.
/// `sign` is 1 if the triangle is the tested primitive, and -1 if it is the query's. Weights of
/// corners that are not negative are those of a point of the triangle, whatever they are.
HWY_INLINE void consider_face(Shortest& shortest, const Face& face, const Vectors (&to_corner)[3],
                              float sign) {
  const ManyTag tag;
  const Many zero = hn::Zero(tag);
  Many weight[3];  // of the corner across from each edge
  for (int k = 0; k < 3; ++k)
    weight[k] = hn::Max(dot(face.inward[k], to_corner[k]), zero);
  const Many sum = hn::Add(hn::Add(weight[0], weight[1]), weight[2]);
  const Many scale = hn::Div(hn::Set(tag, sign), sum);
  Vectors offset = {zero, zero, zero};
  for (int k = 0; k < 3; ++k)
    offset = along(hn::Mul(weight[k], scale), to_corner[(k + 2) % 3], offset);
  // The inverse of a sum within these limits is rounded as one of its size.
  const auto is_known = hn::And(hn::Gt(sum, hn::Set(tag, kWideUnderflow)),
                                hn::Lt(sum, hn::Set(tag, 1 / kWideUnderflow)));
  shortest.consider_where(is_known, offset, dot(offset, offset));
}

/// Sets lower bounds of the squared distances of the pairs, and returns the least square of the
/// offsets between points of both. The nearest points may be wrong by anything: whatever direction
/// they give, a gap along it is a gap. `error` is that of each coordinate of a difference of
/// corners.
///
/// An offset is one between points of both primitives, whatever shares and weights it is made of: a
/// sum of differences of corners by weights that are not negative and sum to 1. The error of such a
/// sum is at most that of one difference. Between edges three differences, two products and two
/// sums are rounded; products are of edges, which are up to two lengths long. The weights of a
/// face's corners sum to 1 but for 4.01 u. That and the error of corners (wide_bounds.h) is
/// below 24.5 u of what kCornerError is multiplied by: each coordinate is off by `error` at most.
HWY_INLINE float set_bounds(float (&bounds)[NearPairs::kMost], const NearPairs& pairs, float error,
                            float unit_of_tested) {
  const ManyTag tag;
  Many least = hn::Set(tag, std::numeric_limits<float>::infinity());
  for (std::size_t part = 0; part < pairs.count; part += hn::Lanes(tag)) {
    const Vectors p[3] = {corner_in(pairs.tested[0], part), corner_in(pairs.tested[1], part),
                          corner_in(pairs.tested[2], part)};
    const Vectors q[3] = {corner_in(pairs.query[0], part), corner_in(pairs.query[1], part),
                          corner_in(pairs.query[2], part)};
    const TriangleEdges tested(p[0], p[1], p[2]);
    const TriangleEdges query(q[0], q[1], q[2]);
    const Face tested_face(tested, cross(tested.edge[0], tested.edge[1]));
    const Face query_face(query, cross(query.edge[0], query.edge[1]));
    Vectors between[3][3];  // [tested corner][query corner]
    Shortest shortest;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        between[i][j] = minus(q[j], p[i]);
        consider_edges(shortest, tested, i, query, j, between[i][j]);
      }
    }
    for (int k = 0; k < 3; ++k) {
      consider_face(shortest, tested_face, {between[0][k], between[1][k], between[2][k]}, 1);
      const Vectors from_query[3] = {minus(p[k], q[0]), minus(p[k], q[1]), minus(p[k], q[2])};
      consider_face(shortest, query_face, from_query, -1);
    }
    // The direction is as long as its square says, which is not so where that underflowed.
    const Many scale = hn::IfThenElseZero(hn::Ge(shortest.square, hn::Set(tag, kWideUnderflow)),
                                          inverse(hn::Sqrt(shortest.square)));
    const Vectors direction = {hn::Mul(shortest.offset.x, scale), hn::Mul(shortest.offset.y, scale),
                               hn::Mul(shortest.offset.z, scale)};
    Many gap = hn::Set(tag, std::numeric_limits<float>::infinity());
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        gap = hn::Min(gap, dot(direction, between[i][j]));
    }
    const Many step =
        hn::Mul(known(tag, hn::Sub(gap, hn::Set(tag, 4 * error))), hn::Set(tag, unit_of_tested));
    hn::Store(hn::Mul(step, step), tag, bounds + part);
    least =
        hn::IfThenElse(hn::FirstN(tag, pairs.count - part), hn::Min(least, shortest.square), least);
  }
  return hn::GetLane(hn::MinOfLanes(tag, least));
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
