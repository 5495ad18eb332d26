#pragma once

#include <cstdint>
#include <vector>

#include <graze/engine/mesh/mesh_intersection.h>

namespace graze {

/// Holds the parts of a MeshIntersection, each together with what belongs to it instead of places
/// in lists.
struct CaseIntersection {
  /// Holds an IntersectionSegment.
  struct Segment {
    std::uint32_t from;               ///< index into `points`
    std::uint32_t to;                 ///< index into `points`
    std::vector<TrianglePair> pairs;  ///< the pairs of triangles that meet in it
    bool operator==(const Segment&) const = default;
  };
  /// Holds an IntersectionCurve.
  struct Curve {
    bool is_closed;                 ///< true if it ends where it began
    std::vector<Segment> segments;  ///< end to end
    bool operator==(const Curve&) const = default;
  };
  /// Holds an IntersectionPolygon.
  struct Polygon {
    std::vector<std::uint32_t> corners;  ///< indices into `points`, around it
    std::vector<TrianglePair> pairs;     ///< the pairs of triangles that meet in it
    bool operator==(const Polygon&) const = default;
  };
  /// Holds a TouchingPoint.
  struct Touch {
    std::uint32_t point;              ///< index into `points`
    std::vector<TrianglePair> pairs;  ///< the pairs of triangles that meet in it
    bool operator==(const Touch&) const = default;
  };

  std::vector<IntersectionPoint> points;      ///< ascending by position
  std::vector<Curve> curves;                  ///< curves made of segments
  std::vector<std::vector<Polygon>> patches;  ///< patches, each a list of polygons that are
                                              ///< connected
  std::vector<Touch> touching_points;         ///< points on no segment and no polygon
};

/// Returns the same intersection as parts.
CaseIntersection in_parts(const MeshIntersection& intersection);

/// True if two agree in every bit, but for the sign of zeros.
bool is_same(const CaseIntersection& a, const CaseIntersection& b);

}  // namespace graze
