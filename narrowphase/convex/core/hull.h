#pragma once

#include <graze/narrowphase/convex/core/vector.h>

#include <cstdint>
#include <vector>

namespace graze::narrowphase {

/// The boundary of a convex hull. Corners are those points that are no convex combination of
/// others; faces are its facets, exactly: triangles are one face only where they lie in one plane
/// to the last bit. So the faces bound the hull whatever the points are, and rays ask them.
/// Contacts ask for something coarser: `contact_faces`.
struct Hull {
  struct Face {
    Vec3 normal;              ///< unit, outward; a component is off by at most 8 u
    std::uint32_t first = 0;  ///< the first of its corners in the loops, counter-clockwise from
                              ///< outside
    std::uint32_t count = 0;
  };
  Vec3 middle;                      ///< the middle of the box around the hull
  double bounding_radius = 0;       ///< no corner is further than this from the middle
  std::vector<Vec3> corners;        ///< relative to the middle, each coordinate rounded once
  std::vector<Vec3> exact_corners;  ///< the corners as the points that they were
  std::vector<Face> faces;
  std::vector<double> offsets;  ///< metres along their normals from the middle to the faces' planes
  std::vector<std::uint32_t> loops;
  std::vector<std::uint32_t> beyond;  ///< the face beyond each edge, from a loop's corner to its
                                      ///< next

  /// The faces that bodies rest on: convex polygons of corners (contact_faces.h).
  std::vector<Face> contact_faces;
  std::vector<double> contact_offsets;  ///< metres from the middle to their planes, which no point
                                        ///< of the hull is beyond
  std::vector<std::uint32_t> contact_loops;
};

/// Names what points that have no hull with a volume lie in.
enum class HullDefect { None, Point, Line, Plane };

/// Builds the hull of at least one finite point. All signs are exact, so that corners and faces are
/// the hull's whatever the points are. Takes O(n f) for n points and f faces: points are added one
/// by one, and each asks every face. Barber, Dobkin, Huhdanpaa, "The quickhull algorithm for convex
/// hulls" (1996), whose horizon this uses.
HullDefect build_hull(const std::vector<Vec3>& points, Hull& hull);

}  // namespace graze::narrowphase
