// Finds which of many points is farthest in a direction, for each SIMD target that the compiler
// knows; the widest that the CPU has is chosen when the program runs. No operation is fused and
// each is in its place in dot() of vector.h, so that all of them round alike.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/convex/core/point_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/narrowphase/convex/core/point_rows.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::size_t kMostLanes = 8;
using Tag = hn::CappedTag<double, kMostLanes>;
using Lanes = hn::Vec<Tag>;

struct Direction {
  explicit HWY_INLINE Direction(const Vec3& of)
      : one(of), x(hn::Set(Tag(), of.x)), y(hn::Set(Tag(), of.y)), z(hn::Set(Tag(), of.z)) {}
  const Vec3& one;
  Lanes x, y, z;
};

HWY_INLINE Lanes along(const PointPointers& p, std::size_t i, const Direction& d) {
  const Tag tag;
  return hn::Add(
      hn::Add(hn::Mul(hn::LoadU(tag, p.x + i), d.x), hn::Mul(hn::LoadU(tag, p.y + i), d.y)),
      hn::Mul(hn::LoadU(tag, p.z + i), d.z));
}

HWY_INLINE double along_one(const PointPointers& p, std::size_t i, const Direction& d) {
  return dot({p.x[i], p.y[i], p.z[i]}, d.one);
}

std::size_t farthest(const PointPointers& p, std::size_t count, const Vec3& direction) {
  const Tag tag;
  const Direction d(direction);
  const std::size_t lanes = hn::Lanes(tag);
  std::size_t best = 0, i = 0;
  double most = along_one(p, 0, d);
  if (count >= lanes) {
    // Each lane has a farthest point of its own; numbers of points are exact as doubles.
    Lanes most_of = along(p, 0, d), first_of = hn::Zero(tag);
    for (i = lanes; i + lanes <= count; i += lanes) {
      const Lanes here = along(p, i, d);
      const auto is_more = hn::Gt(here, most_of);
      most_of = hn::IfThenElse(is_more, here, most_of);
      first_of = hn::IfThenElse(is_more, hn::Set(tag, static_cast<double>(i)), first_of);
    }
    HWY_ALIGN double values[kMostLanes];
    HWY_ALIGN double firsts[kMostLanes];
    hn::Store(most_of, tag, values);
    hn::Store(first_of, tag, firsts);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t at = static_cast<std::size_t>(firsts[lane]) + lane;
      if (values[lane] > most || (values[lane] == most && at < best))
        most = values[lane], best = at;
    }
  }
  for (; i < count; ++i) {
    const double here = along_one(p, i, d);
    if (here > most) most = here, best = i;
  }
  return best;
}

std::size_t next_beyond(const PointPointers& p, std::size_t count, const Vec3& direction,
                        double least, std::size_t i) {
  const Tag tag;
  const Direction d(direction);
  const std::size_t lanes = hn::Lanes(tag);
  const Lanes bound = hn::Set(tag, least);
  for (; i + lanes <= count; i += lanes) {
    const auto at = hn::FindFirstTrue(tag, hn::Ge(along(p, i, d), bound));
    if (at >= 0) return i + static_cast<std::size_t>(at);
  }
  while (i < count && !(along_one(p, i, d) >= least))
    ++i;
  return i;
}

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {
namespace {

HWY_EXPORT(farthest);
HWY_EXPORT(next_beyond);

}  // namespace

std::size_t PointRows::farthest(const Vec3& direction, std::size_t count) const {
  return HWY_DYNAMIC_DISPATCH(farthest)({x_.data(), y_.data(), z_.data()}, count, direction);
}

std::size_t PointRows::next_beyond(const Vec3& direction, double along, std::size_t from) const {
  return HWY_DYNAMIC_DISPATCH(next_beyond)({x_.data(), y_.data(), z_.data()}, x_.size(), direction,
                                           along, from);
}

}  // namespace graze::narrowphase
#endif
