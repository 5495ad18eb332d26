#pragma once

#include <graze/narrowphase/convex/core/core.h>

#include <optional>

namespace graze::narrowphase {

/// Names the method that found the direction of a penetration.
enum class PenetrationSource {
  Fixed,     ///< the best of axes, faces and pairs of edges, and of what is beside these
  Formula,   ///< the two lie along the same axes: see aligned_parting.h
  Polytope,  ///< the expanding polytope
  Ccd,       ///< libccd's MPR, asked because the polytope ended open
};

/// Says how to part two sets that overlap: moving B by `depth` along `normal` leaves them touching
/// at most. The depth is computed for the normal from the sets' own supports, whatever found the
/// normal: it always parts them, and a bad normal costs depth alone.
struct Penetration {
  Vec3 normal;   ///< unit, from A to B
  double depth;  ///< metres, >= 0
  Vec3 point_a;  ///< the point of A farthest along the normal
  Vec3 point_b;  ///< the point of B farthest against the normal
  PenetrationSource source;
  bool is_open = false;  ///< true if the depth is not proved to be the least, to the tolerance
  bool has_witnesses = false;  ///< true if the points are where the two meet when they part
  double lower = 0;            ///< metres: the least depth is at least this, unless `is_open`
};

/// Returns the least penetration of two cores whose radii are added, by formula where they are
/// aligned, else proved from below by an expanding polytope: off by at most depth_tolerance().
/// Where the polytope ends open, libccd's MPR is asked, too, and axes, faces and pairs of edges,
/// and the least of what is beside the best of these is taken; of that it is only known that it
/// parts the two. van den Bergen, "Proximity queries and penetration depth computation on 3D game
/// objects" (2001).
Penetration penetration(const Core& a, const Core& b);

/// Returns by how much a depth may exceed the least, metres: kDepthTolerance of the smaller size,
/// bounding radius and radius, and kDepthRounding of the pair's scale, beside which nothing finer
/// is known of two of very different sizes.
double depth_tolerance(const Core& a, const Core& b);

inline constexpr double kDepthTolerance = 1e-6;
inline constexpr double kDepthRounding = 0x1p-36;

/// Returns the width by which A extends past B along a unit direction from A to B, from the
/// supports: negative if that direction separates them.
Penetration along(const Core& a, const Core& b, const Vec3& unit_direction);

/// The most support points that libccd may ask for. Its loops have no end of their own where
/// rounding keeps them from their tolerance.
inline constexpr int kCcdBudget = 1000;

/// Returns a unit direction from A to B along which two overlapping sets part soon, by MPR; no
/// other function calls libccd. Returns nothing if libccd fails, that is, finds no overlap, spends
/// kCcdBudget, or answers with something that is no number. libccd compares with absolute epsilons,
/// so it is given the sets in units of the smaller one's size. Snethen, "XenoCollide", Game
/// Programming Gems 7 (2008).
std::optional<Vec3> ask_ccd(const Core& a, const Core& b);

}  // namespace graze::narrowphase
