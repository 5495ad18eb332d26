#pragma once

#include <graze/narrowphase/convex/vector.h>

#include <cstdint>
#include <vector>

namespace graze::narrowphase {

/// The boundary of a convex hull. Corners that lie within faces or edges are left out; triangles
/// that lie in one plane but for rounding are one face.
struct Hull {
  struct Face {
    Vec3 normal;          ///< unit, outward
    std::uint32_t first;  ///< of its corners in `loops`, counter-clockwise from outside
    std::uint32_t count;
  };
  Vec3 middle;                ///< of the box around it
  double reach = 0;           ///< no corner is further than this from the middle
  std::vector<Vec3> corners;  ///< relative to the middle, each coordinate rounded once
  std::vector<Face> faces;
  std::vector<std::uint32_t> loops;
};

/// What points that have no hull with a volume lie in.
enum class HullDefect { None, Point, Line, Plane };

/// The hull of at least one finite point. All signs are exact, so that the triangles are the hull's
/// whatever the points are; merging them to faces is not, and of no weight but for contacts.
/// O(n f) for f faces: points are added one by one, and each asks every face.
/// Barber, Dobkin, Huhdanpaa, "The quickhull algorithm for convex hulls" (1996), whose horizon this
/// uses.
HullDefect build_hull(const std::vector<Vec3>& points, Hull& hull);

}  // namespace graze::narrowphase
