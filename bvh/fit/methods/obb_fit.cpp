#include <graze/bvh/fit/methods/box_frame.h>
#include <graze/bvh/fit/methods/ditetrahedron.h>
#include <graze/bvh/fit/methods/moments.h>
#include <graze/bvh/fit/methods/smallest_rectangle.h>
#include <graze/bvh/fit/obb_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>

#include <vector>

namespace graze {
namespace {

using bvh::Axes;
using bvh::LocalPoints;

/// Returns the axes turned about axis k to the smallest rectangle around the shadow along it.
Axes turned(const Axes& axes, int k, const LocalPoints& points) {
  const Eigen::Vector3d u = axes.col((k + 1) % 3);
  const Eigen::Vector3d v = axes.col((k + 2) % 3);
  std::vector<bvh::PlanePoint> shadow;
  shadow.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d point = points.point(i);
    shadow.push_back({point.dot(u), point.dot(v)});
  }
  const bvh::PlanePoint side = bvh::smallest_rectangle_side(shadow, bvh::kVolumePadding);
  return bvh::axes_along(axes.col(k), side.x * u + side.y * v);
}

/// Each turn must gain this part of the volume, more than rounding can pretend.
constexpr double kLeastGain = 1e-9;
constexpr int kMaxTurns = 100;

Axes refined(Axes axes, const LocalPoints& points) {
  double volume = padded_volume(extents_along(axes, points));
  int vain_turns = 0;
  for (int turn = 0; turn < kMaxTurns && vain_turns < 3; ++turn) {
    // Axis 0 of what `turned` returns is the one just turned about: 1 and 2 take their turns next.
    const Axes next = turned(axes, turn == 0 ? 0 : 1 + turn % 2, points);
    const double next_volume = padded_volume(extents_along(next, points));
    ++vain_turns;
    if (next_volume < volume * (1 - kLeastGain)) {
      axes = next;
      volume = next_volume;
      vain_turns = 0;
    }
  }
  return axes;
}

}  // namespace

Obb covariance_box(std::span<const Eigen::Vector3d> points) {
  return bvh::in_standard_arithmetic([&]() -> Obb {
    const LocalPoints local(points);
    return box_along(bvh::principal_axes(bvh::covariance(local)), local, points);
  });
}

Obb ditetrahedron_box(std::span<const Eigen::Vector3d> points) {
  return bvh::in_standard_arithmetic([&]() -> Obb {
    const LocalPoints local(points);
    const Axes axes = bvh::ditetrahedron_axes(local);
    const bool is_better = half_surface(extents_along(axes, local)) <
                           half_surface(extents_along(Axes::Identity(), local));
    return box_along(is_better ? axes : Axes(Axes::Identity()), local, points);
  });
}

Obb bounding_obb(std::span<const Eigen::Vector3d> points) {
  return bvh::in_standard_arithmetic([&]() -> Obb {
    const LocalPoints local(points);
    Axes best = Axes::Identity();
    double least = padded_volume(extents_along(best, local));
    for (const Axes& start : {Axes(Axes::Identity()), bvh::principal_axes(bvh::covariance(local)),
                              bvh::ditetrahedron_axes(local)}) {
      const Axes axes = refined(start, local);
      const double volume = padded_volume(extents_along(axes, local));
      if (volume < least) {
        least = volume;
        best = axes;
      }
    }
    return box_along(best, local, points);
  });
}

}  // namespace graze
