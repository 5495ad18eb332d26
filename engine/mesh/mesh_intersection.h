#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/engine/mesh/pair.h>
#include <graze/narrowphase/triangle_distance.h>

namespace graze {

/// A corner of an intersection.
struct IntersectionPoint {
  Eigen::Vector3d position;  ///< metres, off by at most 2 ulp of the largest placed coordinate
  Feature feature_a;         ///< the smallest feature of A in which it lies, exactly
  Feature feature_b;         ///< the smallest feature of B in which it lies, exactly

  bool operator==(const IntersectionPoint&) const = default;
};

/// A segment between two points, and the pairs of triangles that meet in it: two triangles cross in
/// a segment of their own, all triangles at an edge share one that lies on it.
struct IntersectionSegment {
  std::uint32_t from;        ///< index into MeshIntersection::points
  std::uint32_t to;          ///< index into MeshIntersection::points
  std::uint32_t first_pair;  ///< index into MeshIntersection::pairs
  std::uint32_t pair_count;  ///< how many pairs there are from there on

  bool operator==(const IntersectionSegment&) const = default;
};

/// Segments end to end: `segment_count` of them from `first_segment` on.
struct IntersectionCurve {
  std::uint32_t first_segment;  ///< index into MeshIntersection::segments
  std::uint32_t segment_count;  ///< the number of segments, at least 1
  bool is_closed;               ///< true if it ends where it began

  bool operator==(const IntersectionCurve&) const = default;
};

/// A convex polygon of three to six points, in which triangles in one plane meet.
struct IntersectionPolygon {
  std::array<std::uint32_t, 6>
      corners;                 ///< indices into MeshIntersection::points, the first `corner_count`
  std::uint32_t corner_count;  ///< 3 to 6
  std::uint32_t first_pair;    ///< index into MeshIntersection::pairs
  std::uint32_t pair_count;    ///< how many pairs there are from there on

  bool operator==(const IntersectionPolygon&) const = default;
};

/// Polygons that are connected by their edges, in one plane or more.
struct IntersectionPatch {
  std::uint32_t first_polygon;  ///< index into MeshIntersection::polygons
  std::uint32_t polygon_count;  ///< the number of polygons, at least 1

  bool operator==(const IntersectionPatch&) const = default;
};

/// A point in which triangles meet and which is on no segment and no polygon.
struct TouchingPoint {
  std::uint32_t point;       ///< index into MeshIntersection::points
  std::uint32_t first_pair;  ///< index into MeshIntersection::pairs
  std::uint32_t pair_count;  ///< how many pairs there are from there on

  bool operator==(const TouchingPoint&) const = default;
};

/// All points that two meshes' surfaces share: curves, patches of coplanar surface, and points.
/// Every segment of `segments` belongs to one curve, every polygon to one patch; the edges of
/// polygons are not listed among the segments. Points ascend lexicographically by position; curves,
/// patches and touching points by their points.
struct MeshIntersection {
  std::vector<IntersectionPoint> points;       ///< ascending by position
  std::vector<IntersectionSegment> segments;   ///< each belongs to one curve
  std::vector<IntersectionCurve> curves;       ///< ascending by their points
  std::vector<IntersectionPolygon> polygons;   ///< each belongs to one patch
  std::vector<IntersectionPatch> patches;      ///< ascending by their points
  std::vector<TouchingPoint> touching_points;  ///< ascending
  std::vector<TrianglePair> pairs;             ///< the pairs of each part, side by side

  bool empty() const { return points.empty(); }

  /// Returns the segments of a curve, end to end.
  std::span<const IntersectionSegment> segments_of(const IntersectionCurve& curve) const {
    return {segments.data() + curve.first_segment, curve.segment_count};
  }
  /// Returns the polygons of a patch.
  std::span<const IntersectionPolygon> polygons_of(const IntersectionPatch& patch) const {
    return {polygons.data() + patch.first_polygon, patch.polygon_count};
  }
  /// Returns the pairs of triangles that meet in a segment, a polygon or a touching point,
  /// ascending.
  template <typename Part>
  std::span<const TrianglePair> pairs_of(const Part& part) const {
    return {pairs.data() + part.first_pair, part.pair_count};
  }

  bool operator==(const MeshIntersection&) const = default;
};

/// Finds where the surfaces of two placed meshes meet. The result is empty exactly when
/// intersects() is false. Which points, segments and polygons there are and how they are connected
/// is exact: ends are joined where they are the same crossing of an edge and a face, of two edges,
/// or the same vertex, edges and vertices being welded where placed positions are equal. Positions
/// alone are rounded; points that round to one position stay two.
///
/// A curve runs through the points where just two segments meet, and ends at all others: where an
/// open mesh ends, where curves branch, and at patches. Closed meshes that cross no vertex and no
/// edge with an edge, nor touch along a plane, meet in closed curves only. A mesh that crosses
/// itself, or whose edges are not welded, has its curves on each sheet. Swapping A and B gives the
/// same points and curves with the sides of all features and pairs swapped (law 4). It takes the
/// time of find_triangle_pairs(), and O(k log k) for k pairs. Only surfaces count, touching points
/// included. Throws as intersects() does.
MeshIntersection find_intersection(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                   const IntersectionSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
