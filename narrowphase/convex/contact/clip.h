#pragma once

#include <graze/narrowphase/convex/core/contact_face.h>

#include <cstdint>
#include <optional>

namespace graze::narrowphase {

/// Holds what is left of a face between the sides of another.
struct ClippedFace {
  static constexpr int kMostCorners = 2 * ContactFace::kMostCorners;
  struct Corner {
    Vec3 point;
    std::uint32_t own;  ///< the corner, or the edge (kEdge + its first corner), of the clipped face
    std::uint32_t other;  ///< 0, or the edge (kEdge + its first corner) that cut it there
  };
  static constexpr std::uint32_t kEdge = 0x10000;
  ClippedFace() {}
  // The corners are in a union so that those beyond the count are not initialised: most are never
  // used.
  union {
    Corner corner[kMostCorners];
  };
  int count = 0;
  bool has_laid_edges = false;  ///< true if corners may be missing that are `within` so much of
                                ///< others
};

/// Returns the part of `face`, a polygon, segment or point, that lies between the planes through
/// the edges of `sides` and along `direction`, on whose side its face is; where `sides` is a
/// segment, its planes are those through its ends that are as nearly at right angles to it as they
/// can be. So what is left lies before or behind `sides`, as seen in that direction. Sutherland,
/// Hodgman, "Reentrant polygon clipping" (1974).
///
/// An edge of the face whose ends are both `within` so much of a plane, metres, is not cut by it
/// but lies in it: corners that stick out slide back along the face to the nearest point that the
/// face has in the plane. So faces whose edges coincide keep their corners, and their names,
/// however they jitter, and no point leaves the face.
ClippedFace clip(const ContactFace& face, const ContactFace& sides, const Vec3& direction,
                 double within);

/// True if two edges of a face meet at so small an angle that points which are off them by no more
/// than rounding may lie well past the corner.
bool is_sharp(const ContactFace& face);

/// Returns the point of a face's edges that is nearest to a given point, as seen along a unit
/// direction. The given point is beyond no edge of the face but for rounding, which is at most
/// `slack`, metres, as it is seen so, and the two are as near as that unless it lies past a sharp
/// corner. Returns nothing if it lies as far within.
std::optional<Vec3> on_nearest_edge(const ContactFace& face, const Vec3& point,
                                    const Vec3& direction, double slack);

}  // namespace graze::narrowphase
