#pragma once

// Which points stand for a region of two meshes. Private to engine/world.

#include <graze/bvh/pose.h>
#include <graze/narrowphase/convex/contact/contact_points.h>

#include <cstddef>
#include <span>
#include <vector>

namespace graze {

/// Where two meshes meet: points of either, and how deep they are, metres.
struct MetPoints {
  narrowphase::Vec3 a;
  narrowphase::Vec3 b;
  double depth;
};

/// A depth that lacks less than this share of the region's size is the greatest.
inline constexpr double kSameMetDepth = 1e-9;

/// What the points of a region have in common.
struct RegionFrame {
  const Pose& pose_a;
  const Pose& pose_b;
  narrowphase::Vec3 exit;  ///< unit, in which A leaves
  double size;             ///< metres, of the region
  double margin = 0;       ///< metres, that all depths have in them
};

/// The number of the deepest of the points, of which there is one at least; the first of those that
/// are as deep.
std::size_t deepest_of(std::span<const MetPoints> met, double size);

/// Adds the contacts that stand for a region, four at most: the ends in four directions that turn
/// with A, and the deepest. A contact is known by the sides of A and of B that the way out leads to
/// and by which end it is, so that it keeps its name while triangles change, and while the meshes
/// touch, part as far as a margin allows, and touch again.
void add_ends(std::span<const MetPoints> met, const RegionFrame& region,
              std::vector<narrowphase::ContactPoint>& contacts);

}  // namespace graze
