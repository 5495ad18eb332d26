// Compiles the kernels for each SIMD target that the compiler knows; the widest that the CPU has is
// chosen when the program runs. No operation is fused, so that all of them round alike.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/volumes/spheres/sphere_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/narrowphase/volumes/spheres/sphere_distance.h>
#include <graze/narrowphase/volumes/spheres/sphere_kernels.h>
#include <hwy/highway.h>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::size_t kAtOnce = 8;  // pairs whose verdicts are written at once
using Tag = hn::CappedTag<double, kAtOnce>;
using Lanes = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

/// One element, copied to every lane.
template <std::size_t N>
struct One {
  std::array<const double*, N> row;
  HWY_INLINE Lanes load(std::size_t r, std::size_t) const { return hn::Set(Tag(), *row[r]); }
};

/// Consecutive elements of each row.
template <std::size_t N>
struct Many {
  std::array<const double*, N> row;
  HWY_INLINE Lanes load(std::size_t r, std::size_t first) const {
    return hn::LoadU(Tag(), row[r] + first);
  }
};

/// The last elements, fewer than a block, with zeros behind them.
template <std::size_t N>
struct Rest {
  double values[N][kAtOnce] = {};
  Rest(const Many<N>& many, std::size_t first, std::size_t count) {
    for (std::size_t r = 0; r < N; ++r) {
      for (std::size_t i = first; i < count; ++i)
        values[r][i - first] = many.row[r][i];
    }
  }
  HWY_INLINE Lanes load(std::size_t r, std::size_t first) const {
    return hn::LoadU(Tag(), values[r] + first);
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

struct Sure {
  Mask apart;
  Mask touching;
};

/// Answers sign_of_offset() in every lane; nothing is sure where `is_valid` is not set. Comparisons
/// with NaN are false.
HWY_INLINE Sure compare(Lanes x, Lanes y, Lanes z, Lanes radius, Mask is_valid) {
  const Tag tag;
  const Lanes distance2 = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
  const Lanes radius2 = hn::Mul(radius, radius);
  const Lanes bound = hn::Add(hn::Mul(hn::Set(tag, kSquareBound), hn::Add(distance2, radius2)),
                              hn::Set(tag, kSquareUnderflow));
  const Lanes gap = hn::Sub(distance2, radius2);
  return {hn::And(is_valid, hn::Gt(gap, bound)), hn::And(is_valid, hn::Lt(gap, hn::Neg(bound)))};
}

/// Values that are not finite make the gap or the bound infinite or NaN, so that nothing is sure; a
/// negative radius does not, and is tested.
struct JudgeSpheres {
  template <typename A, typename B>
  HWY_INLINE Sure operator()(const A& a, const B& b, std::size_t first) const {
    const Lanes zero = hn::Zero(Tag());
    const Lanes radius_a = a.load(3, first);
    const Lanes radius_b = b.load(3, first);
    return compare(hn::Sub(b.load(0, first), a.load(0, first)),
                   hn::Sub(b.load(1, first), a.load(1, first)),
                   hn::Sub(b.load(2, first), a.load(2, first)), hn::Add(radius_a, radius_b),
                   hn::And(hn::Ge(radius_a, zero), hn::Ge(radius_b, zero)));
  }
};

/// Returns the offset from the centre to the box along one axis, without branches; clears lanes of
/// `is_valid` where the maximum could hide that the numbers are no box, or no numbers.
HWY_INLINE Lanes offset_to_box(Lanes centre, Lanes low, Lanes high, Mask& is_valid) {
  const Tag tag;
  const Lanes largest = hn::Set(tag, std::numeric_limits<double>::max());
  is_valid = hn::And(is_valid, hn::And(hn::Le(low, high), hn::Le(hn::Abs(centre), largest)));
  is_valid = hn::And(is_valid, hn::And(hn::Ge(low, hn::Neg(largest)), hn::Le(high, largest)));
  const Lanes zero = hn::Zero(tag);
  return hn::Add(hn::Max(hn::Sub(low, centre), zero), hn::Max(hn::Sub(centre, high), zero));
}

struct JudgeSphereAndBox {
  template <typename A, typename B>
  HWY_INLINE Sure operator()(const A& sphere, const B& box, std::size_t first) const {
    const Lanes radius = sphere.load(3, first);
    Mask is_valid = hn::Ge(radius, hn::Zero(Tag()));
    const Lanes x =
        offset_to_box(sphere.load(0, first), box.load(0, first), box.load(3, first), is_valid);
    const Lanes y =
        offset_to_box(sphere.load(1, first), box.load(1, first), box.load(4, first), is_valid);
    const Lanes z =
        offset_to_box(sphere.load(2, first), box.load(2, first), box.load(5, first), is_valid);
    return compare(x, y, z, radius, is_valid);
  }
};

HWY_INLINE std::uint64_t bits_of(Mask mask) {
  std::uint8_t bits[8] = {};  // Highway may write eight bytes
  hn::StoreMaskBits(Tag(), mask, bits);
  return bits[0];
}

/// Makes bit i of the low byte the lowest bit of byte i.
HWY_INLINE std::uint64_t byte_for_each(std::uint64_t bits) {
  const std::uint64_t apart = (bits * 0x0101010101010101u) & 0x8040201008040201u;
  return ((apart + 0x7f7f7f7f7f7f7f7fu) >> 7) & 0x0101010101010101u;
}

/// Writes verdicts of the pairs from `first` on, at most a block of them.
template <typename Judge, typename A, typename B>
HWY_INLINE void judge_block(const A& a, const B& b, std::size_t first, std::size_t count,
                            std::uint8_t* verdicts) {
  std::uint64_t apart = 0, touching = 0;
  for (std::size_t lane = 0; lane < kAtOnce; lane += hn::Lanes(Tag())) {
    const Sure sure = Judge()(a, b, first + lane);
    apart |= bits_of(sure.apart) << lane;
    touching |= bits_of(sure.touching) << lane;
  }
  const std::uint64_t unsure = ~(apart | touching) & 0xff;
  const std::uint64_t bytes =
      byte_for_each(touching) * kSureTouching + byte_for_each(unsure) * kUnsure;
  for (std::size_t i = 0; i < count; ++i)
    verdicts[i] = static_cast<std::uint8_t>(bytes >> (8 * i));
}

template <typename Judge, typename A, typename B>
HWY_INLINE void judge(const A& a, const B& b, std::size_t count, std::uint8_t* verdicts) {
  std::size_t first = 0;
  for (; first + kAtOnce <= count; first += kAtOnce)
    judge_block<Judge>(a, b, first, kAtOnce, verdicts + first);
  if (first == count) return;
  judge_block<Judge>(rest_of(a, first, count), rest_of(b, first, count), 0, count - first,
                     verdicts + first);
}

void judge_one_sphere(const SphereRows& one, const SphereRows& many, std::size_t count,
                      std::uint8_t* verdicts) {
  judge<JudgeSpheres>(One<4>{one}, Many<4>{many}, count, verdicts);
}

void judge_sphere_pairs(const SphereRows& a, const SphereRows& b, std::size_t count,
                        std::uint8_t* verdicts) {
  judge<JudgeSpheres>(Many<4>{a}, Many<4>{b}, count, verdicts);
}

void judge_sphere_and_boxes(const SphereRows& one, const BoxRows& many, std::size_t count,
                            std::uint8_t* verdicts) {
  judge<JudgeSphereAndBox>(One<4>{one}, Many<6>{many}, count, verdicts);
}

void judge_box_and_spheres(const BoxRows& one, const SphereRows& many, std::size_t count,
                           std::uint8_t* verdicts) {
  judge<JudgeSphereAndBox>(Many<4>{many}, One<6>{one}, count, verdicts);
}

void judge_sphere_box_pairs(const SphereRows& spheres, const BoxRows& boxes, std::size_t count,
                            std::uint8_t* verdicts) {
  judge<JudgeSphereAndBox>(Many<4>{spheres}, Many<6>{boxes}, count, verdicts);
}

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {

HWY_EXPORT(judge_one_sphere);
HWY_EXPORT(judge_sphere_pairs);
HWY_EXPORT(judge_sphere_and_boxes);
HWY_EXPORT(judge_box_and_spheres);
HWY_EXPORT(judge_sphere_box_pairs);

void judge_one_sphere(const SphereRows& one, const SphereRows& many, std::size_t count,
                      std::uint8_t* verdicts) {
  HWY_DYNAMIC_DISPATCH(judge_one_sphere)(one, many, count, verdicts);
}

void judge_sphere_pairs(const SphereRows& a, const SphereRows& b, std::size_t count,
                        std::uint8_t* verdicts) {
  HWY_DYNAMIC_DISPATCH(judge_sphere_pairs)(a, b, count, verdicts);
}

void judge_sphere_and_boxes(const SphereRows& one, const BoxRows& many, std::size_t count,
                            std::uint8_t* verdicts) {
  HWY_DYNAMIC_DISPATCH(judge_sphere_and_boxes)(one, many, count, verdicts);
}

void judge_box_and_spheres(const BoxRows& one, const SphereRows& many, std::size_t count,
                           std::uint8_t* verdicts) {
  HWY_DYNAMIC_DISPATCH(judge_box_and_spheres)(one, many, count, verdicts);
}

void judge_sphere_box_pairs(const SphereRows& spheres, const BoxRows& boxes, std::size_t count,
                            std::uint8_t* verdicts) {
  HWY_DYNAMIC_DISPATCH(judge_sphere_box_pairs)(spheres, boxes, count, verdicts);
}

}  // namespace graze::narrowphase
#endif
