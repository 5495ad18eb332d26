#pragma once

#include <graze/narrowphase/convex/core/core.h>

namespace graze::narrowphase {

/// Holds what an expanding polytope found out about the least depth, metres.
struct PolytopeDepth {
  Vec3 normal;   ///< unit, from A to B: the depth along it is `upper`
  double upper;  ///< the height of a supporting plane: no less than the least depth
  double lower;  ///< the height of a face of a polytope inside the difference of the sets: no more
                 ///< than the least depth, and for sets that are apart minus how far a point of
                 ///< that face is
  bool is_closed;  ///< true if the two are as near as asked
};

/// Returns the least depth of two sets that overlap, to `tolerance`, metres. The polytope starts as
/// a tetrahedron of support points, wherever the origin is, and grows at the face nearest to the
/// origin, where a new corner replaces all faces that it sees; so no start from another search is
/// needed. It ends open when rounding tears the horizon or kMostPolytopeCorners are spent.
/// Allocates nothing. van den Bergen, "Proximity queries and penetration depth computation on 3D
/// game objects" (2001).
PolytopeDepth polytope_depth(const Core& a, const Core& b, double tolerance);

inline constexpr int kMostPolytopeCorners = 240;

}  // namespace graze::narrowphase
