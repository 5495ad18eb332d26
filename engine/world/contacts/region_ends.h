#pragma once

// Finds the points that stand for a region of two meshes. Private to engine/world.

#include <graze/bvh/pose.h>
#include <graze/narrowphase/convex/contact/contact_points.h>

#include <cstddef>
#include <span>
#include <vector>

namespace graze {

/// A place where two meshes meet: a point of either, and their depth, metres.
struct MetPoints {
  narrowphase::Vec3 a;
  narrowphase::Vec3 b;
  double depth;
};

/// A depth that is less than the greatest by no more than this share of the region's size counts as
/// the greatest.
inline constexpr double kSameMetDepth = 1e-9;

/// The data that the points of a region share.
struct RegionFrame {
  const Pose& pose_a;
  const Pose& pose_b;
  narrowphase::Vec3 exit;  ///< the unit direction in which A leaves
  double size;             ///< the size of the region, metres
  double margin = 0;       ///< the margin that all depths contain, metres
};

/// Returns the number of the deepest point, the first of those that are equally deep. There must be
/// at least one point.
std::size_t deepest_of(std::span<const MetPoints> met, double size);

/// Adds the contacts that stand for a region, at most four: the ends in four directions that turn
/// with A, and the deepest. The feature of a contact consists of the sides of A and of B that the
/// way out leads to and of which end it is, so that it stays while triangles change, and while the
/// meshes touch, part as far as a margin allows, and touch again.
void add_ends(std::span<const MetPoints> met, const RegionFrame& region,
              std::vector<narrowphase::ContactPoint>& contacts);

}  // namespace graze
