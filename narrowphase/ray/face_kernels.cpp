// ray_values.cpp's values in lanes of four doubles with a fused operation, for each SIMD target
// that has both. The error of a product is exact by either way, and all else is done in the same
// order, so that the values are the same bits but for the sign of a zero of the normal. Where
// integers would have to be asked, it answers nothing.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/ray/face_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/narrowphase/ray/face_kernels.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

// Better targets have smaller numbers.
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2

namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::FixedTag<double, 4>;
using Half = hn::FixedTag<double, 2>;

/// DoublePair in lanes.
template <typename AnyTag>
struct Pairs {
  using Lanes = hn::Vec<AnyTag>;
  Lanes high;
  Lanes low;

  static HWY_INLINE Pairs ordered_sum(Lanes a, Lanes b) {
    const Lanes sum = hn::Add(a, b);
    return {sum, hn::Sub(b, hn::Sub(sum, a))};
  }
  static HWY_INLINE Pairs two_sum(Lanes a, Lanes b) {
    const Lanes sum = hn::Add(a, b);
    const Lanes b_virtual = hn::Sub(sum, a);
    const Lanes a_virtual = hn::Sub(sum, b_virtual);
    return {sum, hn::Add(hn::Sub(a, a_virtual), hn::Sub(b, b_virtual))};
  }
  static HWY_INLINE Pairs exact_difference(Lanes a, Lanes b) { return two_sum(a, hn::Neg(b)); }

  HWY_INLINE Pairs operator-() const { return {hn::Neg(high), hn::Neg(low)}; }
  HWY_INLINE Pairs operator+(const Pairs& b) const {
    const Pairs highs = two_sum(high, b.high);
    const Pairs lows = two_sum(low, b.low);
    const Pairs sum = ordered_sum(highs.high, hn::Add(highs.low, lows.high));
    return ordered_sum(sum.high, hn::Add(lows.low, sum.low));
  }
  HWY_INLINE Pairs operator*(const Pairs& b) const {
    const Lanes product = hn::Mul(high, b.high);
    const Lanes error = hn::MulSub(high, b.high, product);
    return ordered_sum(product,
                       hn::Add(error, hn::Add(hn::Mul(high, b.low), hn::Mul(low, b.high))));
  }
  HWY_INLINE Pairs operator*(Lanes b) const {
    const Lanes product = hn::Mul(high, b);
    const Lanes error = hn::MulSub(high, b, product);
    return ordered_sum(product, hn::Add(error, hn::Mul(low, b)));
  }
};

using Vectors = Pairs<Tag>;  // x, y and z, and a lane that nobody asks

/// x, y, z to y, z, x.
HWY_INLINE hn::Vec<Tag> turned(hn::Vec<Tag> v) {
  alignas(32) static constexpr std::int64_t kTurn[4] = {1, 2, 0, 3};
  return hn::TableLookupLanes(v, hn::SetTableIndices(Tag(), kTurn));
}
HWY_INLINE Vectors turned(const Vectors& v) {
  return {turned(v.high), turned(v.low)};
}

/// a.y b.z - a.z b.y and so on.
HWY_INLINE Vectors cross(const Vectors& a, const Vectors& b) {
  const Vectors a_yzx = turned(a), b_yzx = turned(b);
  const Vectors a_zxy = turned(a_yzx), b_zxy = turned(b_yzx);
  return a_yzx * b_zxy + -(a_zxy * b_yzx);
}

HWY_INLINE double largest(hn::Vec<Tag> v) {
  alignas(32) double c[4];
  hn::Store(hn::Abs(v), Tag(), c);
  return HWY_MAX(c[0], HWY_MAX(c[1], c[2]));
}

HWY_INLINE bool is_in_range(double size) {
  return size >= kSmallestFace && size <= kLargestFace;
}

/// The quotient of the two lanes, as operator/ of DoublePair.
HWY_INLINE double quotient(const Pairs<Half>& both) {
  const hn::FixedTag<double, 1> one;
  using One = Pairs<hn::FixedTag<double, 1>>;
  alignas(16) double high[2], low[2];
  hn::Store(both.high, Half(), high);
  hn::Store(both.low, Half(), low);
  const double first = high[0] / high[1];
  const One ahead{hn::Set(one, high[0]), hn::Set(one, low[0])};
  const One along{hn::Set(one, high[1]), hn::Set(one, low[1])};
  const One remainder = ahead + -(along * hn::Set(one, first));
  return first + hn::GetLane(remainder.high) / high[1];
}

bool face_values(const FaceInput& in, FaceValues& out) {
  const Tag tag;
  const Half half;
  const auto load = [tag, half](const double* p) HWY_ATTR {
    return hn::Combine(tag, hn::Set(half, p[2]), hn::LoadU(half, p));
  };
  const auto a = load(in.corner[0]);
  const auto d = load(in.direction);
  const Vectors u = Vectors::exact_difference(load(in.corner[1]), a);
  const Vectors v = Vectors::exact_difference(load(in.corner[2]), a);
  const Vectors w = Vectors::exact_difference(a, load(in.origin));
  const Vectors n = cross(u, v);
  const double size_u = largest(u.high), size_v = largest(v.high), size_w = largest(w.high);
  if (!is_in_range(size_u) || !is_in_range(size_v) || !is_in_range(size_w)) return false;
  const double size = size_u * size_v;

  // (x + y) + z of n . w and n . d, a lane each.
  const Vectors ahead = n * w, along = n * Vectors{d, hn::Zero(tag)};
  const auto first = [](hn::Vec<Tag> l, hn::Vec<Tag> r)
                         HWY_ATTR { return hn::InterleaveLower(Tag(), l, r); };
  const auto second = [](hn::Vec<Tag> l, hn::Vec<Tag> r)
                          HWY_ATTR { return hn::InterleaveUpper(Tag(), l, r); };
  const auto xz_high = first(ahead.high, along.high), xz_low = first(ahead.low, along.low);
  const auto y_high = second(ahead.high, along.high), y_low = second(ahead.low, along.low);
  const Pairs<Half> x{hn::LowerHalf(half, xz_high), hn::LowerHalf(half, xz_low)};
  const Pairs<Half> y{hn::LowerHalf(half, y_high), hn::LowerHalf(half, y_low)};
  const Pairs<Half> z{hn::UpperHalf(half, xz_high), hn::UpperHalf(half, xz_low)};
  const Pairs<Half> both = x + y + z;
  alignas(16) double sums[2];
  hn::Store(both.high, half, sums);
  const double size_n = largest(n.high);
  if (!(HWY_MAX(sums[0], -sums[0]) >= kWellConditioned * (size * size_w)) ||
      !(HWY_MAX(sums[1], -sums[1]) >= kWellConditioned * 2 * size) ||
      !(size_n >= kWellConditioned * size))
    return false;
  out.against_normal = sums[1];
  out.scale = quotient(both);

  const auto scaled = hn::Div(n.high, hn::Set(tag, size_n));
  alignas(32) double squares[4];
  hn::Store(hn::Mul(scaled, scaled), tag, squares);
  const auto length = hn::Sqrt(hn::Set(tag, (squares[0] + squares[1]) + squares[2]));
  hn::StoreU(hn::Div(scaled, length), tag, out.normal);
  return true;
}

#else

bool face_values(const FaceInput&, FaceValues&) {
  return false;
}

#endif

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {

HWY_EXPORT(face_values);

bool face_values(const FaceInput& in, FaceValues& out) {
  return HWY_DYNAMIC_DISPATCH(face_values)(in, out);
}

}  // namespace graze::narrowphase
#endif
