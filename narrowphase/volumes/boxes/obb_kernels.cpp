// Compiles may_overlap() for each SIMD target that the compiler knows; the widest that the CPU has
// is chosen when the program runs. No operation is fused and each is in its place in
// obb_overlap.cpp and bvh/value/separating_axes.h, so that all of them round alike.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/volumes/boxes/obb_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/narrowphase/volumes/boxes/obb_kernels.h>
#include <graze/narrowphase/volumes/boxes/obb_slack.h>
#include <hwy/highway.h>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::size_t kAtOnce = VolumeRows<kObbRows>::kAtOnce;
using Tag = hn::CappedTag<double, kAtOnce>;
using Lanes = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

struct Boxes {
  Lanes row[kObbRows];

  const Lanes* half() const { return row + kHalfRow; }
  const Lanes* axis(std::size_t i) const { return row + kAxisRow + 3 * i; }
};

/// Holds some boxes B in the frames of as many boxes A.
struct InFrame {
  Lanes rotation[3][3];
  Lanes size[3][3];
  Lanes offset[3];
};

HWY_INLINE Boxes load(const ObbRow& one, std::size_t) {
  Boxes boxes;
  for (std::size_t r = 0; r < kObbRows; ++r)
    boxes.row[r] = hn::Set(Tag(), one[r]);
  return boxes;
}

HWY_INLINE Boxes load(const RowPointers<kObbRows>& many, std::size_t first) {
  Boxes boxes;
  for (std::size_t r = 0; r < kObbRows; ++r)
    boxes.row[r] = hn::LoadU(Tag(), many[r] + first);
  return boxes;
}

/// Answers is_second_first() in every lane. Nearly always the sums of the half extents decide.
HWY_INLINE Mask second_first(const Boxes& a, const Boxes& b) {
  Mask is_second = hn::Lt(a.row[0], b.row[0]);
  Mask is_open = hn::Eq(a.row[0], b.row[0]);
  for (std::size_t r = 1; r < kDeviationRow && !hn::AllFalse(Tag(), is_open); ++r) {
    is_second = hn::Or(is_second, hn::And(is_open, hn::Lt(a.row[r], b.row[r])));
    is_open = hn::And(is_open, hn::Eq(a.row[r], b.row[r]));
  }
  return is_second;
}

HWY_INLINE void put_in_order(Boxes& a, Boxes& b) {
  const Mask is_second = second_first(a, b);
  for (std::size_t r = 0; r < kObbRows; ++r) {
    const Lanes first = hn::IfThenElse(is_second, b.row[r], a.row[r]);
    b.row[r] = hn::IfThenElse(is_second, a.row[r], b.row[r]);
    a.row[r] = first;
  }
}

HWY_INLINE Lanes dot(const Lanes* a, const Lanes* b) {
  return hn::Add(hn::Add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
}

HWY_INLINE Lanes slack(const Boxes& a, const Boxes& b) {
  const Tag tag;
  const Lanes sum_a = a.row[kSumRow], sum_b = b.row[kSumRow];
  const Lanes of_a =
      hn::Mul(a.row[kDeviationRow], hn::Add(hn::Mul(hn::Set(tag, kDeviationOfA), sum_a),
                                            hn::Mul(hn::Set(tag, kDeviationOfAOnB), sum_b)));
  const Lanes of_b = hn::Mul(b.row[kDeviationRow], hn::Mul(hn::Set(tag, kDeviationOfB), sum_b));
  const Lanes rounding = hn::Add(hn::Mul(hn::Set(tag, kRoundingOfA), sum_a),
                                 hn::Mul(hn::Set(tag, kRoundingOfB), sum_b));
  const Lanes result = hn::Add(hn::Add(hn::Add(of_a, of_b), rounding), hn::Set(tag, kObbUnderflow));
  const Mask is_in_range = hn::Le(hn::Add(sum_a, sum_b), hn::Set(tag, kLargestObbSum));
  return hn::IfThenElse(is_in_range, result, hn::Set(tag, std::numeric_limits<double>::infinity()));
}

HWY_INLINE InFrame in_frame(const Boxes& a, const Boxes& b) {
  Lanes between[3];
  for (std::size_t k = 0; k < 3; ++k)
    between[k] = hn::Sub(b.row[kTranslationRow + k], a.row[kTranslationRow + k]);
  InFrame frame;
  for (std::size_t i = 0; i < 3; ++i) {
    frame.offset[i] = dot(a.axis(i), between);
    for (std::size_t j = 0; j < 3; ++j) {
      frame.rotation[i][j] = dot(a.axis(i), b.axis(j));
      frame.size[i][j] = hn::Abs(frame.rotation[i][j]);
    }
  }
  return frame;
}

/// Returns half + p0 q0 + p1 q1 + p2 q2: the radii of two boxes along an axis of one of them, in
/// the order of bvh/value/separating_axes.h.
HWY_INLINE Lanes projected_radius(Lanes half, const Lanes* p, Lanes q0, Lanes q1, Lanes q2) {
  const Lanes first = hn::Add(half, hn::Mul(p[0], q0));
  return hn::Add(hn::Add(first, hn::Mul(p[1], q1)), hn::Mul(p[2], q2));
}

HWY_INLINE Mask is_beyond(Lanes distance, Lanes radius, Lanes margin) {
  return hn::Gt(hn::Abs(distance), hn::Add(radius, margin));
}

HWY_INLINE Mask apart_by_faces(const InFrame& f, const Boxes& a, const Boxes& b, Lanes margin) {
  const auto& s = f.size;
  Mask apart = is_beyond(
      f.offset[0], projected_radius(a.half()[0], b.half(), s[0][0], s[0][1], s[0][2]), margin);
  for (std::size_t i = 1; i < 3; ++i) {
    const Lanes radius = projected_radius(a.half()[i], b.half(), s[i][0], s[i][1], s[i][2]);
    apart = hn::Or(apart, is_beyond(f.offset[i], radius, margin));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const Lanes column[3] = {f.rotation[0][j], f.rotation[1][j], f.rotation[2][j]};
    const Lanes radius = projected_radius(b.half()[j], a.half(), s[0][j], s[1][j], s[2][j]);
    apart = hn::Or(apart, is_beyond(dot(f.offset, column), radius, margin));
  }
  return apart;
}

HWY_INLINE Mask apart_by_edges(const InFrame& f, const Boxes& a, const Boxes& b, Lanes margin,
                               Mask apart) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const Lanes distance = hn::Sub(hn::Mul(f.offset[i2], f.rotation[i1][j]),
                                     hn::Mul(f.offset[i1], f.rotation[i2][j]));
      const Lanes radius_a =
          hn::Add(hn::Mul(a.half()[i1], f.size[i2][j]), hn::Mul(a.half()[i2], f.size[i1][j]));
      const Lanes radius = hn::Add(hn::Add(radius_a, hn::Mul(b.half()[j1], f.size[i][j2])),
                                   hn::Mul(b.half()[j2], f.size[i][j1]));
      apart = hn::Or(apart, is_beyond(distance, radius, margin));
    }
  }
  return apart;
}

template <typename A, typename B>
HWY_INLINE std::uint64_t overlapping(const A& rows_a, const B& rows_b, std::size_t first) {
  Boxes a = load(rows_a, first);
  Boxes b = load(rows_b, first);
  put_in_order(a, b);
  const InFrame frame = in_frame(a, b);
  const Lanes margin = slack(a, b);
  Mask apart = apart_by_faces(frame, a, b, margin);
  if (!hn::AllTrue(Tag(), apart)) apart = apart_by_edges(frame, a, b, margin, apart);
  std::uint8_t bits[8] = {};  // Highway may write eight bytes
  hn::StoreMaskBits(Tag(), hn::Not(apart), bits);
  return bits[0];
}

template <typename A, typename B>
HWY_INLINE void find(const A& a, const B& b, std::size_t count, std::uint8_t* hits) {
  const std::size_t width = hn::Lanes(Tag());
  for (std::size_t first = 0; first < count; first += width) {
    const std::uint64_t bits = overlapping(a, b, first);
    for (std::size_t i = first; i < first + width && i < count; ++i)
      hits[i] = bits >> (i - first) & 1;
  }
}

void one_box(const ObbRow& one, const RowPointers<kObbRows>& many, std::size_t count,
             std::uint8_t* hits) {
  find(one, many, count, hits);
}

void box_pairs(const RowPointers<kObbRows>& a, const RowPointers<kObbRows>& b, std::size_t count,
               std::uint8_t* hits) {
  find(a, b, count, hits);
}

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {
namespace {

HWY_EXPORT(one_box);
HWY_EXPORT(box_pairs);

}  // namespace

void find_overlaps(const ObbRow& one, const RowPointers<kObbRows>& many, std::size_t count,
                   std::uint8_t* hits) {
  HWY_DYNAMIC_DISPATCH(one_box)(one, many, count, hits);
}

void find_overlaps(const RowPointers<kObbRows>& a, const RowPointers<kObbRows>& b,
                   std::size_t count, std::uint8_t* hits) {
  HWY_DYNAMIC_DISPATCH(box_pairs)(a, b, count, hits);
}

}  // namespace graze::narrowphase
#endif
