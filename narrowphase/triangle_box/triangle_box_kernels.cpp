// Makes the triage of triangles and boxes for each SIMD target that the compiler knows; the widest
// that the CPU has is chosen when the program runs. Operation by operation it does what
// triangle_box_triage.cpp does, in its order and never fused, so that all of them round alike.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/triangle_box/triangle_box_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/narrowphase/lanes/row_lanes-inl.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/triangle_box/remaining_axes.h>
#include <graze/narrowphase/triangle_box/triangle_box_batch.h>
#include <hwy/highway.h>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

struct TriangleLanes {
  Vector a, b, c;
};

struct Box {
  Vector low, high;
};

HWY_INLINE Vector size_of(const Vector& v) {
  return {hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)};
}

HWY_INLINE Lanes largest(const Vector& v) {
  return hn::Max(hn::Max(v.x, v.y), v.z);
}

HWY_INLINE Vector half_of(const Vector& v) {
  const Lanes half = hn::Set(Tag(), 0.5);
  return {hn::Mul(half, v.x), hn::Mul(half, v.y), hn::Mul(half, v.z)};
}

HWY_INLINE Vector sum_of(const Vector& a, const Vector& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

/// Returns (a0 + a1 + a2 + a3) + (b0 + b1) + c of absolute values.
HWY_INLINE Lanes sum_of_sizes(Lanes a0, Lanes a1, Lanes a2, Lanes a3, Lanes b0, Lanes b1, Lanes c) {
  const Lanes a = hn::Add(hn::Add(hn::Abs(a0), hn::Abs(a1)), hn::Add(hn::Abs(a2), hn::Abs(a3)));
  return hn::Add(hn::Add(a, hn::Add(hn::Abs(b0), hn::Abs(b1))), hn::Abs(c));
}

/// Adds up sizes in the order of triangle_box_triage.cpp.
HWY_INLINE Lanes sum_of_sizes(const TriangleLanes& t, const Box& box) {
  const Lanes even = sum_of_sizes(t.a.x, t.a.z, t.b.y, t.c.x, box.low.x, box.high.x, box.low.z);
  const Lanes odd = sum_of_sizes(t.a.y, t.b.x, t.b.z, t.c.y, box.low.y, box.high.y, box.high.z);
  return hn::Add(hn::Add(even, odd), hn::Abs(t.c.z));
}

HWY_INLINE Mask is_ordered(const Box& box) {
  return hn::And(hn::And(hn::Le(box.low.x, box.high.x), hn::Le(box.low.y, box.high.y)),
                 hn::Le(box.low.z, box.high.z));
}

HWY_INLINE Mask is_apart_along(Lanes a, Lanes b, Lanes c, Lanes low, Lanes high) {
  return hn::Or(hn::Gt(hn::Min(hn::Min(a, b), c), high), hn::Lt(hn::Max(hn::Max(a, b), c), low));
}

HWY_INLINE Mask is_apart_along_box_axes(const TriangleLanes& t, const Box& box) {
  return hn::Or(hn::Or(is_apart_along(t.a.x, t.b.x, t.c.x, box.low.x, box.high.x),
                       is_apart_along(t.a.y, t.b.y, t.c.y, box.low.y, box.high.y)),
                is_apart_along(t.a.z, t.b.z, t.c.z, box.low.z, box.high.z));
}

/// Holds an edge, its size, and one of its ends as seen from the box's centre.
struct Edge {
  Vector f, size, v;
};

HWY_INLINE Edge edge(const Vector& from, const Vector& to, const Vector& centre) {
  const Vector f = difference(to, from);
  return {f, size_of(f), difference(from, centre)};
}

/// Returns gap() of triangle_box_triage.cpp; `size_m` is the size of `half_m`.
HWY_INLINE Lanes gap(Lanes f_j, Lanes f_k, Lanes size_j, Lanes size_k, Lanes v_j, Lanes v_k,
                     Lanes h_j, Lanes h_k, Lanes half_m, Lanes size_m) {
  const Lanes p = hn::Sub(hn::Mul(f_k, v_j), hn::Mul(f_j, v_k));
  const Lanes radius = hn::Add(hn::Mul(h_j, size_k), hn::Mul(h_k, size_j));
  return hn::Sub(hn::Abs(hn::Sub(p, half_m)), hn::Add(size_m, radius));
}

/// Returns the largest gap along the three axes that an edge makes.
HWY_INLINE Lanes largest_gap(const Edge& e, const Vector& h, const Vector& half_n,
                             const Vector& size_n) {
  const Lanes x = gap(e.f.y, e.f.z, e.size.y, e.size.z, e.v.y, e.v.z, h.y, h.z, half_n.x, size_n.x);
  const Lanes y = gap(e.f.z, e.f.x, e.size.z, e.size.x, e.v.z, e.v.x, h.z, h.x, half_n.y, size_n.y);
  const Lanes z = gap(e.f.x, e.f.y, e.size.x, e.size.y, e.v.x, e.v.y, h.x, h.y, half_n.z, size_n.z);
  return hn::Max(hn::Max(x, y), z);
}

HWY_INLINE Verdicts triage_lanes(const TriangleLanes& t, const Box& box) {
  const Tag tag;
  const Lanes size = sum_of_sizes(t, box);
  const Mask is_valid =
      hn::And(is_ordered(box), hn::Le(size, hn::Set(tag, std::numeric_limits<double>::max())));
  const Mask is_box_apart = hn::And(is_valid, is_apart_along_box_axes(t, box));
  const Mask is_open = hn::AndNot(is_box_apart, is_valid);
  if (hn::AllFalse(tag, is_open)) return {bits_of(is_box_apart), 0};
  const Vector centre = half_of(sum_of(box.low, box.high));
  const Vector h = half_of(difference(box.high, box.low));
  const Edge e = edge(t.a, t.b, centre);
  const Edge f = edge(t.b, t.c, centre);
  const Edge g = edge(t.c, t.a, centre);
  const Lanes largest_f = hn::Max(hn::Max(largest(e.size), largest(f.size)), largest(g.size));
  const Mask is_in_range = hn::And(hn::And(hn::Ge(largest_f, hn::Set(tag, kSmallestBoxSize)),
                                           hn::Ge(size, hn::Set(tag, kSmallestBoxSize))),
                                   hn::Le(size, hn::Set(tag, kLargestBoxSize)));
  const Lanes edge_bound = hn::Mul(hn::Mul(hn::Set(tag, kEdgeBound), largest_f), size);
  const Lanes normal_bound =
      hn::Mul(hn::Mul(hn::Mul(hn::Set(tag, kNormalBound), largest_f), largest_f), size);
  const Vector normal = cross(e.f, f.f);
  const Vector half_n = half_of(normal);
  const Lanes normal_gap = hn::Sub(hn::Abs(dot(normal, e.v)), dot(h, size_of(normal)));
  const Vector size_n = size_of(half_n);
  const Lanes edge_gap =
      hn::Max(hn::Max(largest_gap(e, h, half_n, size_n), largest_gap(f, h, half_n, size_n)),
              largest_gap(g, h, half_n, size_n));
  const Mask is_decided = hn::And(is_open, is_in_range);
  const Mask is_apart =
      hn::And(is_decided, hn::Or(hn::Gt(edge_gap, edge_bound), hn::Gt(normal_gap, normal_bound)));
  const Mask is_touching = hn::And(is_decided, hn::And(hn::Lt(edge_gap, hn::Neg(edge_bound)),
                                                       hn::Lt(normal_gap, hn::Neg(normal_bound))));
  return {bits_of(hn::Or(is_box_apart, is_apart)), bits_of(is_touching)};
}

template <typename Rows>
HWY_INLINE Vector load(const Rows& rows, std::size_t row, std::size_t first) {
  return {rows.load(row, first), rows.load(row + 1, first), rows.load(row + 2, first)};
}

template <typename Triangles, typename Boxes>
HWY_INLINE Verdicts triage_block(const Triangles& triangles, const Boxes& boxes,
                                 std::size_t first) {
  Verdicts block;
  for (std::size_t lane = 0; lane < kAtOnce; lane += hn::Lanes(Tag())) {
    const std::size_t at = first + lane;
    const Verdicts some =
        triage_lanes({load(triangles, 0, at), load(triangles, 3, at), load(triangles, 6, at)},
                     {load(boxes, 0, at), load(boxes, 3, at)});
    block.apart |= some.apart << lane;
    block.touching |= some.touching << lane;
  }
  return block;
}

template <typename Triangles, typename Boxes>
HWY_INLINE void triage_rows(const Triangles& triangles, const Boxes& boxes, std::size_t count,
                            Verdicts* verdicts) {
  std::size_t first = 0;
  for (; first + kAtOnce <= count; first += kAtOnce)
    *verdicts++ = triage_block(triangles, boxes, first);
  if (first == count) return;
  const std::uint32_t used = (std::uint32_t{1} << (count - first)) - 1;
  const Verdicts block =
      triage_block(rest_of(triangles, first, count), rest_of(boxes, first, count), std::size_t{0});
  *verdicts = {block.apart & used, block.touching & used};
}

void triage_one_triangle(const double* const* triangle, const double* const* boxes,
                         std::size_t count, Verdicts* verdicts) {
  triage_rows(One<9>(triangle), Many<6>(boxes), count, verdicts);
}

void triage_one_box(const double* const* triangles, const double* const* box, std::size_t count,
                    Verdicts* verdicts) {
  triage_rows(Many<9>(triangles), One<6>(box), count, verdicts);
}

void triage_box_pairs(const double* const* triangles, const double* const* boxes, std::size_t count,
                      Verdicts* verdicts) {
  triage_rows(Many<9>(triangles), Many<6>(boxes), count, verdicts);
}

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {

HWY_EXPORT(triage_box_pairs);
HWY_EXPORT(triage_one_box);
HWY_EXPORT(triage_one_triangle);

void triage(const Triangle& triangle, const AabbRows& many, Verdicts* verdicts) {
  const double* rows[9];
  for (int i = 0; i < 9; ++i)
    rows[i] = coordinates(triangle) + i;
  HWY_DYNAMIC_DISPATCH(triage_one_triangle)(rows, many.row.data(), many.size, verdicts);
}

void triage(const Aabb& box, const TriangleRows& many, Verdicts* verdicts) {
  const double* low = box.min.data();
  const double* high = box.max.data();
  const double* rows[6] = {low, low + 1, low + 2, high, high + 1, high + 2};
  HWY_DYNAMIC_DISPATCH(triage_one_box)(many.row.data(), rows, many.size, verdicts);
}

void triage(const TriangleRows& triangles, const AabbRows& boxes, Verdicts* verdicts) {
  HWY_DYNAMIC_DISPATCH(triage_box_pairs)
  (triangles.row.data(), boxes.row.data(), boxes.size, verdicts);
}

}  // namespace graze::narrowphase
#endif
