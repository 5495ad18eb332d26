// Makes the triage of triangle pairs for each SIMD target that the compiler knows; the widest that
// the CPU has is chosen when the program runs. Operation by operation it does what
// triangle_triangle_triage.cpp does, in its order and never fused, so that all of them round alike.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/triangle_pair/triangle_pair_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/narrowphase/lanes/row_lanes-inl.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

struct TriangleLanes {
  Vector a, b, c;
};

/// Holds the signs of three vertices beside a plane.
struct SideMasks {
  Mask is_sure;  ///< set where all three signs are sure
  Mask a, b, c;  ///< set where the vertex is on the negative side
  HWY_INLINE Mask are_equal() const { return hn::Not(hn::Or(hn::Xor(a, b), hn::Xor(a, c))); }
};

HWY_INLINE SideMasks sides_of_plane(const TriangleLanes& plane, const TriangleLanes& other,
                                    Lanes bound) {
  const Vector normal = cross(difference(plane.b, plane.a), difference(plane.c, plane.a));
  const Lanes a = dot(normal, difference(other.a, plane.a));
  const Lanes b = dot(normal, difference(other.b, plane.a));
  const Lanes c = dot(normal, difference(other.c, plane.a));
  const Lanes zero = hn::Zero(Tag());
  return {hn::And(hn::And(hn::Gt(hn::Abs(a), bound), hn::Gt(hn::Abs(b), bound)),
                  hn::Gt(hn::Abs(c), bound)),
          hn::Lt(a, zero), hn::Lt(b, zero), hn::Lt(c, zero)};
}

HWY_INLINE Lanes extent(Lanes a0, Lanes a1, Lanes a2, Lanes b0, Lanes b1, Lanes b2) {
  const Lanes high = hn::Max(hn::Max(hn::Max(a0, a1), a2), hn::Max(hn::Max(b0, b1), b2));
  const Lanes low = hn::Min(hn::Min(hn::Min(a0, a1), a2), hn::Min(hn::Min(b0, b1), b2));
  return hn::Sub(high, low);
}

struct Bound {
  Lanes value;
  Mask is_in_range;
};

HWY_INLINE Bound bound_of(const TriangleLanes& s, const TriangleLanes& t) {
  const Tag tag;
  const Lanes x = extent(s.a.x, s.b.x, s.c.x, t.a.x, t.b.x, t.c.x);
  const Lanes y = extent(s.a.y, s.b.y, s.c.y, t.a.y, t.b.y, t.c.y);
  const Lanes z = extent(s.a.z, s.b.z, s.c.z, t.a.z, t.b.z, t.c.z);
  const Lanes volume = hn::Mul(hn::Mul(x, y), z);
  const Mask is_in_range =
      hn::And(hn::Ge(volume, hn::Set(tag, kSmallestPairVolume)),
              hn::Le(hn::Max(hn::Max(x, y), z), hn::Set(tag, kLargestPairExtent)));
  return {hn::Mul(hn::Set(tag, kPairBound), volume), is_in_range};
}

HWY_INLINE Vector chosen(Mask first, const Vector& a, Mask second, const Vector& b,
                         const Vector& c) {
  return {hn::IfThenElse(first, a.x, hn::IfThenElse(second, b.x, c.x)),
          hn::IfThenElse(first, a.y, hn::IfThenElse(second, b.y, c.y)),
          hn::IfThenElse(first, a.z, hn::IfThenElse(second, b.z, c.z))};
}

/// Says which vertex is the apex (the third, if neither of these), and on which side it lies.
struct ApexLanes {
  Mask is_first, is_second, is_negative;
};

HWY_INLINE ApexLanes apex(const SideMasks& sides) {
  return {hn::Not(hn::Xor(sides.b, sides.c)), hn::Not(hn::Xor(sides.a, sides.c)),
          hn::Xor(hn::Xor(sides.a, sides.b), sides.c)};
}

struct Sure {
  Mask apart, touching;
};

/// Takes the two determinants of meet_in_space() (triangle_triangle.cpp), which order the ends of
/// both intervals on the line that the planes share, for lanes whose signs are sure and not equal.
HWY_INLINE Sure triage_intervals(const TriangleLanes& s, const SideMasks& sides_s,
                                 const TriangleLanes& t, const SideMasks& sides_t, Lanes bound) {
  const ApexLanes apex_s = apex(sides_s);
  const ApexLanes apex_t = apex(sides_t);
  const Vector origin = chosen(apex_s.is_first, s.a, apex_s.is_second, s.b, s.c);
  const Vector next = difference(chosen(apex_s.is_first, s.b, apex_s.is_second, s.c, s.a), origin);
  const Vector last = difference(chosen(apex_s.is_first, s.c, apex_s.is_second, s.a, s.b), origin);
  const Vector offset =
      difference(chosen(apex_t.is_first, t.a, apex_t.is_second, t.b, t.c), origin);
  const Vector t_next = chosen(apex_t.is_first, t.b, apex_t.is_second, t.c, t.a);
  const Vector t_last = chosen(apex_t.is_first, t.c, apex_t.is_second, t.a, t.b);
  const Mask is_turned = hn::Xor(apex_s.is_negative, apex_t.is_negative);
  const Vector with_next = difference(chosen(is_turned, t_last, t_next), origin);
  const Vector with_last = difference(chosen(is_turned, t_next, t_last), origin);
  const Lanes first = dot(cross(next, offset), with_next);
  const Lanes second = dot(cross(last, offset), with_last);
  const Lanes first_gap = hn::IfThenElse(apex_t.is_negative, hn::Neg(first), first);
  const Lanes second_gap = hn::IfThenElse(apex_t.is_negative, second, hn::Neg(second));
  const Lanes minus = hn::Neg(bound);
  return {hn::Or(hn::Gt(first_gap, bound), hn::Gt(second_gap, bound)),
          hn::And(hn::Lt(first_gap, minus), hn::Lt(second_gap, minus))};
}

HWY_INLINE Verdicts bits_of(const Sure& sure) {
  return {bits_of(sure.apart), bits_of(sure.touching)};
}

HWY_INLINE Verdicts triage_lanes(const TriangleLanes& s, const TriangleLanes& t) {
  const Bound bound = bound_of(s, t);
  const SideMasks sides_s = sides_of_plane(t, s, bound.value);
  const SideMasks sides_t = sides_of_plane(s, t, bound.value);
  const Mask apart =
      hn::And(bound.is_in_range, hn::Or(hn::And(sides_s.is_sure, sides_s.are_equal()),
                                        hn::And(sides_t.is_sure, sides_t.are_equal())));
  const Mask is_sure = hn::And(bound.is_in_range, hn::And(sides_s.is_sure, sides_t.is_sure));
  const Mask is_open = hn::AndNot(apart, is_sure);
  if (hn::AllFalse(Tag(), is_open)) return {bits_of(apart), 0};
  const Sure sure = triage_intervals(s, sides_s, t, sides_t, bound.value);
  return bits_of({hn::Or(apart, hn::And(is_open, sure.apart)), hn::And(is_open, sure.touching)});
}

HWY_INLINE std::uint32_t find_apart_lanes(const TriangleLanes& s, const TriangleLanes& t) {
  const Bound bound = bound_of(s, t);
  const SideMasks sides_s = sides_of_plane(t, s, bound.value);
  const SideMasks sides_t = sides_of_plane(s, t, bound.value);
  return bits_of(hn::And(bound.is_in_range, hn::Or(hn::And(sides_s.is_sure, sides_s.are_equal()),
                                                   hn::And(sides_t.is_sure, sides_t.are_equal()))));
}

template <typename Rows>
HWY_INLINE TriangleLanes load(const Rows& rows, std::size_t first) {
  return {{rows.load(0, first), rows.load(1, first), rows.load(2, first)},
          {rows.load(3, first), rows.load(4, first), rows.load(5, first)},
          {rows.load(6, first), rows.load(7, first), rows.load(8, first)}};
}

/// Returns the verdicts of kAtOnce pairs, whose rows may be read whole.
template <typename RowsA, typename RowsB>
HWY_INLINE Verdicts triage_at_once(const RowsA& a, const RowsB& b, std::size_t first) {
  Verdicts found;
  for (std::size_t lane = 0; lane < kAtOnce; lane += hn::Lanes(Tag())) {
    const Verdicts some = triage_lanes(load(a, first + lane), load(b, first + lane));
    found.apart |= some.apart << lane;
    found.touching |= some.touching << lane;
  }
  return found;
}

template <typename RowsA>
HWY_INLINE void triage_rows(const RowsA& a, const Many<9>& b, std::size_t count,
                            Verdicts* verdicts) {
  std::size_t first = 0;
  for (; first + kAtOnce <= count; first += kAtOnce)
    *verdicts++ = triage_at_once(a, b, first);
  if (first == count) return;
  const std::uint32_t used = (std::uint32_t{1} << (count - first)) - 1;
  const Verdicts found =
      triage_at_once(rest_of(a, first, count), rest_of(b, first, count), std::size_t{0});
  *verdicts = {found.apart & used, found.touching & used};
}

void triage_one(const double* const* one, const double* const* many, std::size_t count,
                Verdicts* verdicts) {
  triage_rows(One<9>(one), Many<9>(many), count, verdicts);
}

void triage_pairs(const double* const* a, const double* const* b, std::size_t count,
                  Verdicts* verdicts) {
  triage_rows(Many<9>(a), Many<9>(b), count, verdicts);
}

Verdicts triage_batch(const TrianglePairBatch& batch) {
  const std::uint32_t used = (std::uint32_t{1} << batch.size()) - 1;
  const Block a{batch.row_a(0)};
  const Block b{batch.row_b(0)};
  const Verdicts found = triage_at_once(a, b, 0);
  return {found.apart & used, found.touching & used};
}

std::uint32_t find_apart(const TrianglePairBatch& batch) {
  const std::uint32_t used = (std::uint32_t{1} << batch.size()) - 1;
  const Block a{batch.row_a(0)};
  const Block b{batch.row_b(0)};
  std::uint32_t apart = 0;
  for (std::size_t lane = 0; lane < batch.size(); lane += hn::Lanes(Tag()))
    apart |= find_apart_lanes(load(a, lane), load(b, lane)) << lane;
  return apart & used;
}

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {

HWY_EXPORT(find_apart);
HWY_EXPORT(triage_batch);
HWY_EXPORT(triage_one);
HWY_EXPORT(triage_pairs);

std::uint32_t find_apart(const TrianglePairBatch& batch) {
  return HWY_DYNAMIC_DISPATCH(find_apart)(batch);
}

Verdicts triage(const TrianglePairBatch& batch) {
  if (batch.size() == 0) return {0, 0};
  return HWY_DYNAMIC_DISPATCH(triage_batch)(batch);
}

void triage(const Triangle& triangle, const TriangleRows& many, Verdicts* verdicts) {
  const double* rows[9];
  for (int i = 0; i < 9; ++i)
    rows[i] = coordinates(triangle) + i;
  HWY_DYNAMIC_DISPATCH(triage_one)(rows, many.row.data(), many.size, verdicts);
}

void triage(const TriangleRows& triangles_a, const TriangleRows& triangles_b, Verdicts* verdicts) {
  HWY_DYNAMIC_DISPATCH(triage_pairs)
  (triangles_a.row.data(), triangles_b.row.data(), triangles_b.size, verdicts);
}

}  // namespace graze::narrowphase
#endif
