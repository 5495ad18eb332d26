// find_apart() for each SIMD target that the compiler knows; the widest that the CPU has is chosen
// when the program runs. No operation is fused, so that all of them round alike.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/triangle_pair_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/narrowphase/plane_bound.h>
#include <graze/narrowphase/triangle_pair_batch.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, TrianglePairBatch::kCapacity>;
using Lanes = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

struct Vector {
  Lanes x, y, z;
};

struct Corners {
  Vector a, b, c;
};

HWY_INLINE Vector difference(const Vector& a, const Vector& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
          hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

HWY_INLINE Lanes dot(const Vector& a, const Vector& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Vector size_of(const Vector& a) {
  return {hn::Abs(a.x), hn::Abs(a.y), hn::Abs(a.z)};
}

HWY_INLINE Vector largest(const Vector& a, const Vector& b) {
  return {hn::Max(a.x, b.x), hn::Max(a.y, b.y), hn::Max(a.z, b.z)};
}

HWY_INLINE Lanes largest(const Vector& a) {
  return hn::Max(hn::Max(a.x, a.y), a.z);
}

/// Where all corners of `other` are surely on one side of the plane. Comparisons with NaN are
/// false.
HWY_INLINE Mask are_on_one_side(const Corners& plane, const Corners& other) {
  const Tag tag;
  const Vector edge_b = difference(plane.b, plane.a);
  const Vector edge_c = difference(plane.c, plane.a);
  const Vector normal = cross(edge_b, edge_c);
  const Vector way_a = difference(other.a, plane.a);
  const Vector way_b = difference(other.b, plane.a);
  const Vector way_c = difference(other.c, plane.a);
  const Vector e = largest(size_of(edge_b), size_of(edge_c));
  const Vector d = largest(size_of(way_a), largest(size_of(way_b), size_of(way_c)));
  const Lanes size =
      hn::Add(hn::Add(hn::Mul(hn::Mul(e.y, e.z), d.x), hn::Mul(hn::Mul(e.z, e.x), d.y)),
              hn::Mul(hn::Mul(e.x, e.y), d.z));
  const Mask is_in_range =
      hn::And(hn::Ge(size, hn::Set(tag, kSmallestPlaneSize)),
              hn::Le(largest(largest(e, d)), hn::Set(tag, kLargestDifference)));
  const Lanes bound = hn::Mul(hn::Set(tag, kPlaneBound), size);
  const Lanes minus_bound = hn::Neg(bound);
  const Lanes det_a = dot(normal, way_a);
  const Lanes det_b = dot(normal, way_b);
  const Lanes det_c = dot(normal, way_c);
  const Mask is_above =
      hn::And(hn::And(hn::Gt(det_a, bound), hn::Gt(det_b, bound)), hn::Gt(det_c, bound));
  const Mask is_below = hn::And(hn::And(hn::Lt(det_a, minus_bound), hn::Lt(det_b, minus_bound)),
                                hn::Lt(det_c, minus_bound));
  return hn::And(is_in_range, hn::Or(is_above, is_below));
}

template <typename Row>
HWY_INLINE Corners load(const Row& row) {
  const Tag tag;
  return {{hn::Load(tag, row(0)), hn::Load(tag, row(1)), hn::Load(tag, row(2))},
          {hn::Load(tag, row(3)), hn::Load(tag, row(4)), hn::Load(tag, row(5))},
          {hn::Load(tag, row(6)), hn::Load(tag, row(7)), hn::Load(tag, row(8))}};
}

std::uint32_t find_apart(const TrianglePairBatch& batch) {
  const Tag tag;
  std::uint32_t apart = 0;
  for (std::size_t first = 0; first < batch.size(); first += hn::Lanes(tag)) {
    const Corners a = load([&](std::size_t row) { return batch.row_a(row) + first; });
    const Corners b = load([&](std::size_t row) { return batch.row_b(row) + first; });
    const Mask mask = hn::Or(are_on_one_side(b, a), are_on_one_side(a, b));
    std::uint8_t bits[8] = {};  // Highway may write eight bytes
    hn::StoreMaskBits(tag, mask, bits);
    apart |= static_cast<std::uint32_t>(bits[0]) << first;
  }
  return apart & ((std::uint32_t{1} << batch.size()) - 1);
}

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {

HWY_EXPORT(find_apart);

std::uint32_t find_apart(const TrianglePairBatch& batch) {
  return HWY_DYNAMIC_DISPATCH(find_apart)(batch);
}

}  // namespace graze::narrowphase
#endif
