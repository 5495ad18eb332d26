// This file holds what the kernels on rows of doubles share: vectors of lanes, and how they are
// loaded. It is included once for each SIMD target, in the manner of <hwy/highway.h> itself.

#if defined(GRAZE_NARROWPHASE_ROW_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_NARROWPHASE_ROW_LANES
#undef GRAZE_NARROWPHASE_ROW_LANES
#else
#define GRAZE_NARROWPHASE_ROW_LANES
#endif

#include <hwy/highway.h>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
inline constexpr std::size_t kAtOnce = 8;  ///< the number of elements whose verdicts are written at
                                           ///< once
using Tag = hn::CappedTag<double, kAtOnce>;
using Lanes = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

struct Vector {
  Lanes x, y, z;
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

HWY_INLINE Vector chosen(Mask mask, const Vector& a, const Vector& b) {
  return {hn::IfThenElse(mask, a.x, b.x), hn::IfThenElse(mask, a.y, b.y),
          hn::IfThenElse(mask, a.z, b.z)};
}

/// Returns a mask as bits: bit i is set if lane i is.
HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bits[8] = {};  // Highway may write eight bytes
  hn::StoreMaskBits(Tag(), mask, bits);
  return bits[0];
}

/// One element, copied to every lane.
template <std::size_t N>
struct One {
  double values[N];
  explicit One(const double* const* rows) {
    for (std::size_t r = 0; r < N; ++r)
      values[r] = *rows[r];
  }
  HWY_INLINE Lanes load(std::size_t row, std::size_t) const { return hn::Set(Tag(), values[row]); }
};

/// Consecutive elements of each row.
template <std::size_t N>
struct Many {
  const double* rows[N];
  explicit Many(const double* const* all) {
    for (std::size_t r = 0; r < N; ++r)
      rows[r] = all[r];
  }
  HWY_INLINE Lanes load(std::size_t row, std::size_t first) const {
    return hn::LoadU(Tag(), rows[row] + first);
  }
};

/// Rows of kAtOnce elements each, one behind the other, aligned.
struct Block {
  const double* values;
  HWY_INLINE Lanes load(std::size_t row, std::size_t first) const {
    return hn::Load(Tag(), values + row * kAtOnce + first);
  }
};

/// The last elements, fewer than kAtOnce, with zeros behind them.
template <std::size_t N>
struct Rest {
  double values[N][kAtOnce] = {};
  Rest(const Many<N>& many, std::size_t first, std::size_t count) {
    for (std::size_t r = 0; r < N; ++r) {
      for (std::size_t i = first; i < count; ++i)
        values[r][i - first] = many.rows[r][i];
    }
  }
  HWY_INLINE Lanes load(std::size_t row, std::size_t first) const {
    return hn::LoadU(Tag(), values[row] + first);
  }
};

template <std::size_t N>
One<N> rest_of(const One<N>& one, std::size_t, std::size_t) {
  return one;
}

template <std::size_t N>
Rest<N> rest_of(const Many<N>& many, std::size_t first, std::size_t count) {
  return Rest<N>(many, first, count);
}

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
