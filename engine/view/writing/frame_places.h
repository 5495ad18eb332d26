#pragma once

#include <cstddef>
#include <vector>

#include <graze/bvh/aabb.h>
#include <graze/engine/view/writing/view_data.h>

#include <Eigen/Core>

namespace graze::view {

/// Says what numbers of a page mean: times `scale`, a power of two, plus `center` they are
/// coordinates in metres, so that floats hold what is tiny, huge or far away.
struct NumberFrame {
  Eigen::Vector3d center;
  double scale;

  /// Return the numbers; those beyond a float become the largest ones.
  Eigen::Vector3f numbers(const Eigen::Vector3d& point) const;
  float length(double metres) const;
};

/// Returns the frame about the middle of a box, so that its numbers are at most 1, or 2 for the
/// largest boxes.
NumberFrame number_frame(const Aabb& box);

/// Says which of `places` each frame has. Frames share one until a frame stands apart.
struct FramePlaces {
  std::vector<NumberFrame> places;
  std::vector<std::size_t> of_frame;
};

FramePlaces frame_places(const ShownView& view);

}  // namespace graze::view
