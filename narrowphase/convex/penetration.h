#pragma once

#include <graze/narrowphase/convex/core.h>

namespace graze::narrowphase {

/// Who found the direction of a penetration.
enum class PenetrationSource {
  ExpandingPolytope,  ///< libccd's EPA: near the least depth
  PortalRefinement,   ///< libccd's MPR, because EPA failed: a depth that parts, maybe not the least
  Fallback,           ///< both failed: the best of a few fixed directions
};

/// How to part two sets that overlap: moving B by `depth` along `normal` leaves them touching at
/// most. The depth is computed for the normal from the sets' own supports, whoever found the
/// normal: it always parts them, and a bad normal costs depth alone.
struct Penetration {
  Vec3 normal;   ///< unit, from A to B
  double depth;  ///< metres, >= 0
  Vec3 point_a;  ///< the point of A farthest along the normal
  Vec3 point_b;  ///< and that of B farthest against it
  PenetrationSource source;
};

/// How many support points libccd may ask for in one attempt. Its loops of MPR and EPA have no end
/// of their own when rounding keeps them from their tolerance.
inline constexpr int kCcdBudget = 1000;

/// The least way out, as libccd finds it, of two cores whose radii are added. The direction is off
/// where EPA's polytope has flat faces over round ones: the depth exceeds the least one by at most
/// about kDepthTolerance of the smaller core's reach where EPA succeeds.
/// van den Bergen, "Proximity queries and penetration depth computation on 3D game objects" (2001);
/// Snethen, "XenoCollide", Game Programming Gems 7 (2008).
Penetration penetration(const Core& a, const Core& b);

inline constexpr double kDepthTolerance = 1e-4;

/// The width by which A reaches past B along a unit direction from A to B, from the supports:
/// negative if that direction separates them.
Penetration along(const Core& a, const Core& b, const Vec3& unit_direction);

}  // namespace graze::narrowphase
