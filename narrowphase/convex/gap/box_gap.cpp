#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <limits>

namespace graze::narrowphase {
namespace {

// The slack is that which core_gap.cpp derives for supports, and closed_gap.cpp for feet and
// crossings.
constexpr double kRelativeSlack = 128 * 0x1p-53;

// A gap is known as core_gap() says.
constexpr double kKnown = 0x1p-34 * (1 - 0x1p-8);

// Edges at a smaller angle than about this part boxes no better than their faces.
constexpr double kParallel = 1e-12;

Vec3 corner_of(const Core& box, int index) {
  const Vec3 own{index & 1 ? box.half.x : -box.half.x, index & 2 ? box.half.y : -box.half.y,
                 index & 4 ? box.half.z : -box.half.z};
  return box.at + turned(box, own);
}

class BoxGap {
 public:
  BoxGap(const Core& a, const Core& b) : a_(a), b_(b) {
    for (int i = 0; i < 8; ++i)
      corner_a_[i] = corner_of(a, i), corner_b_[i] = corner_of(b, i);
  }

  CoreGap run() {
    find_points();
    const Vec3 between = unit_or(b_.at - a_.at, {0, 0, 1});
    const Vec3 offset = unit_or(points_.point_b - points_.point_a, between);
    normal_ = offset;
    offer_plane(offset);
    for (int i = 0; i < 3; ++i) {
      offer_axis(a_.axis[i]);
      offer_axis(b_.axis[i]);
      for (int j = 0; j < 3; ++j) {
        const Vec3 product = cross(a_.axis[i], b_.axis[j]);
        if (largest(product) > kParallel) offer_axis(product);
      }
    }
    CoreGap gap{};
    gap.slack = kRelativeSlack * pair_scale(a_, b_);
    gap.upper = length(points_.point_b - points_.point_a);
    gap.lower = std::clamp(apart_ - gap.slack, 0.0, gap.upper);
    gap.verdict = gap.lower > 0 ? GapVerdict::Apart : GapVerdict::Touching;
    const double extent = (a_.bounding_radius + b_.bounding_radius) + length(b_.at - a_.at);
    if (!(gap.upper - gap.lower <= kKnown * extent)) gap.verdict = GapVerdict::NotReached;
    gap.point_a = points_.point_a;
    gap.point_b = points_.point_b;
    gap.normal = normal_;
    return gap;
  }

 private:
  void offer_points(const Vec3& on_a, const Vec3& on_b) {
    const double square = dot(on_a - on_b, on_a - on_b);
    if (square < least_) least_ = square, points_ = {on_a, on_b};
  }

  void find_points() {
    for (int i = 0; i < 8; ++i) {
      offer_points(corner_a_[i], nearest_in_box(b_, corner_a_[i]));
      offer_points(nearest_in_box(a_, corner_b_[i]), corner_b_[i]);
    }
    for_each_edge([&](int a0, int a1) {
      for_each_edge([&](int b0, int b1) {
        const NearestPoints met =
            nearest_of_segments(corner_a_[a0], corner_a_[a1], corner_b_[b0], corner_b_[b1]);
        offer_points(met.point_a, met.point_b);
      });
    });
  }

  template <typename OnEdge>
  static void for_each_edge(OnEdge&& on_edge) {
    for (int k = 1; k < 8; k *= 2) {
      for (int i = 0; i < 8; ++i) {
        if ((i & k) == 0) on_edge(i, i | k);
      }
    }
  }

  void offer_axis(const Vec3& axis) {
    const Vec3 unit = unit_or(axis, normal_);
    offer_plane(unit);
    offer_plane(-unit);
  }

  void offer_plane(const Vec3& normal) {
    const double apart = dot(support(b_, -normal) - support(a_, normal), normal);
    if (apart > apart_) apart_ = apart, normal_ = normal;
  }

  const Core& a_;
  const Core& b_;
  Vec3 corner_a_[8];
  Vec3 corner_b_[8];
  NearestPoints points_;
  double least_ = std::numeric_limits<double>::infinity();
  Vec3 normal_;
  double apart_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

CoreGap box_gap(const Core& a, const Core& b) {
  return BoxGap(a, b).run();
}

}  // namespace graze::narrowphase
