#pragma once

#include <cstdint>
#include <vector>

#include <graze/engine/mesh/mesh_intersection.h>

namespace graze {

/// The parts of a MeshIntersection, each with what belongs to it in place of where that stands in a
/// list.
struct CaseIntersection {
  /// An IntersectionSegment.
  struct Segment {
    std::uint32_t from;               ///< index into `points`
    std::uint32_t to;                 ///< likewise
    std::vector<TrianglePair> pairs;  ///< of triangles that meet in it
    bool operator==(const Segment&) const = default;
  };
  /// An IntersectionCurve.
  struct Curve {
    bool is_closed;                 ///< whether it ends where it began
    std::vector<Segment> segments;  ///< end to end
    bool operator==(const Curve&) const = default;
  };
  /// An IntersectionPolygon.
  struct Polygon {
    std::vector<std::uint32_t> corners;  ///< indices into `points`, around it
    std::vector<TrianglePair> pairs;     ///< of triangles that meet in it
    bool operator==(const Polygon&) const = default;
  };
  /// A TouchingPoint.
  struct Touch {
    std::uint32_t point;              ///< index into `points`
    std::vector<TrianglePair> pairs;  ///< of triangles that meet in it
    bool operator==(const Touch&) const = default;
  };

  std::vector<IntersectionPoint> points;      ///< ascending by position
  std::vector<Curve> curves;                  ///< of segments
  std::vector<std::vector<Polygon>> patches;  ///< each a list of polygons that are connected
  std::vector<Touch> touching_points;         ///< on no segment and no polygon
};

/// The same with everything in its place.
CaseIntersection in_parts(const MeshIntersection& intersection);

/// Whether two agree in every bit, but for the sign of zeros.
bool is_same(const CaseIntersection& a, const CaseIntersection& b);

}  // namespace graze
