// Computes ray_values.cpp's values in lanes of four doubles with a fused operation, for each SIMD
// target that has both. The error of a product is exact by either way, and all else is done in the
// same order, so that the values are the same bits but for the sign of a zero of the normal. Where
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

/// Turns x, y, z to y, z, x.
HWY_INLINE hn::Vec<Tag> turned(hn::Vec<Tag> v) {
  alignas(32) static constexpr std::int64_t kTurn[4] = {1, 2, 0, 3};
  return hn::TableLookupLanes(v, hn::SetTableIndices(Tag(), kTurn));
}
HWY_INLINE Vectors turned(const Vectors& v) {
  return {turned(v.high), turned(v.low)};
}

/// Returns the cross product, whose x is a.y b.z - a.z b.y, and so on.
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

/// Holds x, y and z of two vectors, a lane for each of the two.
struct BothVectors {
  hn::Vec<Half> x, y, z;

  HWY_INLINE BothVectors(hn::Vec<Tag> first, hn::Vec<Tag> second) {
    const auto xz = hn::InterleaveLower(Tag(), first, second);
    x = hn::LowerHalf(Half(), xz);
    y = hn::LowerHalf(Half(), hn::InterleaveUpper(Tag(), first, second));
    z = hn::UpperHalf(Half(), xz);
  }
};

/// Holds a triangle and a ray, and how large they are.
struct Face {
  Vectors u, v, w;  ///< the vectors of ray_stages.h
  hn::Vec<Tag> d;
  double size;    ///< the size of u times that of v
  double size_w;  ///< the size of w
  bool is_in_range;

  HWY_INLINE explicit Face(const FaceInput& in) {
    const Tag tag;
    const auto three = hn::FirstN(tag, 3);
    const auto a = hn::MaskedLoad(three, tag, in.corner[0]);
    u = Vectors::exact_difference(hn::MaskedLoad(three, tag, in.corner[1]), a);
    v = Vectors::exact_difference(hn::MaskedLoad(three, tag, in.corner[2]), a);
    w = Vectors::exact_difference(a, hn::MaskedLoad(three, tag, in.origin));
    d = hn::MaskedLoad(three, tag, in.direction);
    const double size_u = largest(u.high), size_v = largest(v.high);
    size = size_u * size_v;
    size_w = largest(w.high);
    is_in_range = narrowphase::HWY_NAMESPACE::is_in_range(size_u) &&
                  narrowphase::HWY_NAMESPACE::is_in_range(size_v) &&
                  narrowphase::HWY_NAMESPACE::is_in_range(size_w);
  }

  /// True if n . w and n . d are not below the share `least` of what their products may be.
  HWY_INLINE bool is_well_conditioned(double ahead, double along, double least) const {
    return HWY_MAX(ahead, -ahead) >= least * (size * size_w) &&
           HWY_MAX(along, -along) >= least * 2 * size;
  }
};

/// Holds a face's plane and its ray.
struct FaceLine {
  hn::Vec<Tag> normal;
  double along;  ///< n . d, of which the sign matters
  double scale;
};

/// Computes the values as ray_values.cpp does.
HWY_NOINLINE bool slow_crossing(const Face& face, FaceLine& found) {
  const Vectors n = cross(face.u, face.v);
  const Vectors ahead = n * face.w, along = n * Vectors{face.d, hn::Zero(Tag())};
  const BothVectors highs(ahead.high, along.high), lows(ahead.low, along.low);
  const auto both =
      Pairs<Half>{highs.x, lows.x} + Pairs<Half>{highs.y, lows.y} + Pairs<Half>{highs.z, lows.z};
  const hn::FixedTag<double, 1> one;
  using One = Pairs<hn::FixedTag<double, 1>>;
  alignas(16) double high[2], low[2];
  hn::Store(both.high, Half(), high);
  hn::Store(both.low, Half(), low);
  if (!face.is_well_conditioned(high[0], high[1], kWellConditioned)) return false;
  const double first = high[0] / high[1];
  const One numerator{hn::Set(one, high[0]), hn::Set(one, low[0])};
  const One denominator{hn::Set(one, high[1]), hn::Set(one, low[1])};
  const One remainder = numerator + -(denominator * hn::Set(one, first));
  found.normal = n.high;
  found.along = high[1];
  found.scale = first + hn::GetLane(remainder.high) / high[1];
  return true;
}

// This gives the same bits in less than half of the time. Nothing is brought back to pairs on the
// way: a high part is a product or a sum of doubles, whose errors are doubles, and a low part
// gathers these and is rounded. How far slow and quick values may be apart is known; where all
// numbers between round alike, that is what the slow ones round to
// (tests/proofs/face_values.gappa).
//
// Write u = 2^-53, S and W for the sizes of u times v and of w, P = |p| + |q| for the two products
// of a component of n. Slow ones are off by 7 u^2 of each and 3 u^2 of their difference: 10 u^2 P.
// Quick ones have 4 u P of low parts, u from the products' errors, 2 u from lows and u from the
// difference, which are rounded by 2, 3, 3 and 4 u^2 P as they grow; two lows are not multiplied,
// another u^2 P. The interval's ends are rounded by 4 u^2 P: together 27 u^2 P.
constexpr double kNormalsApart = 0x1p-101;

// A component of n is below 2 S, its low part 8 u S. So n . w, as n . d less its low part, has
// three products below 2 S W and sums below 4 and 6 S W. Their low parts are 12 u S W for each
// product and 10 u S W for the sums: rounded by 164 u^2 S W, 24 u^2 S W are not multiplied, and n
// is off by 78 u^2 S W. The slow one is off by 132 u^2 S W, of which 60 are n's, 42 the products'
// and 30 the sums'. Together that is below 2^-66.3 of a sum that is twice kWellConditioned, and
// twice that of their quotient, whose own rounding is below 2^-100.
constexpr double kScalesApart = 0x1p-64;

HWY_INLINE bool quick_crossing(const Face& face, FaceLine& found) {
  const Tag tag;
  const Vectors a = turned(face.u), b = turned(face.v);
  const Vectors c = turned(a), e = turned(b);
  const auto p = hn::Mul(a.high, e.high), q = hn::Mul(c.high, b.high);
  const auto p_low =
      hn::MulAdd(a.high, e.low, hn::MulAdd(a.low, e.high, hn::MulSub(a.high, e.high, p)));
  const auto q_low =
      hn::MulAdd(c.high, b.low, hn::MulAdd(c.low, b.high, hn::MulSub(c.high, b.high, q)));
  const Vectors difference = Vectors::exact_difference(p, q);
  const Vectors n{difference.high, hn::Add(difference.low, hn::Sub(p_low, q_low))};
  const auto normals_apart = hn::Mul(hn::Set(tag, kNormalsApart), hn::Add(hn::Abs(p), hn::Abs(q)));
  found.normal = hn::Add(n.high, hn::Sub(n.low, normals_apart));
  const auto is_sure = hn::Eq(found.normal, hn::Add(n.high, hn::Add(n.low, normals_apart)));

  const auto ahead = hn::Mul(n.high, face.w.high), along = hn::Mul(n.high, face.d);
  const auto ahead_low = hn::MulAdd(
      n.low, face.w.high, hn::MulAdd(n.high, face.w.low, hn::MulSub(n.high, face.w.high, ahead)));
  const auto along_low = hn::MulAdd(n.low, face.d, hn::MulSub(n.high, face.d, along));
  const BothVectors highs(ahead, along), lows(ahead_low, along_low);
  const auto two = Pairs<Half>::two_sum(highs.x, highs.y);
  const auto three = Pairs<Half>::two_sum(two.high, highs.z);
  const auto low_sum =
      hn::Add(hn::Add(hn::Add(lows.x, lows.y), lows.z), hn::Add(two.low, three.low));
  const auto both = Pairs<Half>::ordered_sum(three.high, low_sum);
  alignas(16) double high[2], low[2];
  hn::Store(both.high, Half(), high);
  hn::Store(both.low, Half(), low);
  const double inverse = 1 / high[1];
  const double first = high[0] / high[1];
  // The remainder of a division is a double.
  const hn::FixedTag<double, 1> one;
  const double remainder =
      hn::GetLane(hn::NegMulAdd(hn::Set(one, first), hn::Set(one, high[1]), hn::Set(one, high[0])));
  const double more = (remainder + (low[0] - first * low[1])) * inverse;
  const double scales_apart = kScalesApart * HWY_MAX(first, -first);
  found.along = high[1];
  found.scale = first + (more - scales_apart);
  return hn::AllTrue(tag, is_sure) && found.scale == first + (more + scales_apart) &&
         face.is_well_conditioned(high[0], high[1], 2 * kWellConditioned);
}

bool face_values(const FaceInput& in, FaceValues& out) {
  const Tag tag;
  const Face face(in);
  if (!face.is_in_range) return false;
  FaceLine found;
  if (!quick_crossing(face, found) && !slow_crossing(face, found)) return false;
  out.against_normal = found.along;
  out.scale = found.scale;
  const double size_n = largest(found.normal);
  if (!(size_n >= kWellConditioned * face.size)) return false;
  const auto scaled = hn::Div(found.normal, hn::Set(tag, size_n));
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
