#pragma once

#include <cstdint>
#include <vector>

#include <graze/engine/mesh/mesh_intersection.h>

namespace graze {

/// The parts of a MeshIntersection, each with what belongs to it in place of where that stands in a
/// list.
struct CaseIntersection {
  struct Segment {
    std::uint32_t from;
    std::uint32_t to;
    std::vector<TrianglePair> pairs;
    bool operator==(const Segment&) const = default;
  };
  struct Curve {
    bool is_closed;
    std::vector<Segment> segments;
    bool operator==(const Curve&) const = default;
  };
  struct Polygon {
    std::vector<std::uint32_t> corners;
    std::vector<TrianglePair> pairs;
    bool operator==(const Polygon&) const = default;
  };
  struct Touch {
    std::uint32_t point;
    std::vector<TrianglePair> pairs;
    bool operator==(const Touch&) const = default;
  };

  std::vector<IntersectionPoint> points;
  std::vector<Curve> curves;
  std::vector<std::vector<Polygon>> patches;
  std::vector<Touch> touching_points;
};

/// The same with everything in its place.
CaseIntersection in_parts(const MeshIntersection& intersection);

/// Whether two agree in every bit, but for the sign of zeros.
bool is_same(const CaseIntersection& a, const CaseIntersection& b);

}  // namespace graze
