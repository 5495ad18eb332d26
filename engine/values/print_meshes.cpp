#include <graze/engine/values/text.h>
#include <graze/print.h>

#include <cstdint>
#include <ostream>
#include <vector>

namespace graze {
namespace {

/// A number as an element of a list.
struct Number {
  std::uint32_t value;
};

std::ostream& operator<<(std::ostream& out, const Number& number) {
  return out << Text(number.value);
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const TrianglePairs& pairs) {
  return write_limited(out, pairs, "pairs");
}
std::ostream& operator<<(std::ostream& out, const TriangleList& list) {
  std::vector<Number> numbers;
  for (const std::uint32_t triangle : list)
    numbers.push_back({triangle});
  write_list(out, numbers, "triangles");
  return list.completeness == Completeness::LimitReached ? out << Text(" (limit reached)") : out;
}
std::ostream& operator<<(std::ostream& out, const TriangleDistance& gap) {
  return out << Text("distance ", gap.distance, " from ", gap.point_a, " to ", gap.point_b);
}
std::ostream& operator<<(std::ostream& out, const TriangleIntersection& common) {
  static constexpr const char* kNames[] = {"nothing", "point", "segment", "polygon"};
  Text text(kNames[static_cast<int>(common.kind)]);
  for (const Eigen::Vector3d& corner : common)
    text.add(" "), text.add(corner);
  return out << text;
}
std::ostream& operator<<(std::ostream& out, const TriangleRayHit& hit) {
  return out << Text("hit at ", hit.distance, ", point ", hit.point, ", normal ", hit.normal);
}
std::ostream& operator<<(std::ostream& out, const FirstContact& contact) {
  return out << Text("contact at time ", contact.time)
             << (contact.is_at_start ? ", from the start" : "");
}
std::ostream& operator<<(std::ostream& out, const MeshFirstContact& contact) {
  return out << FirstContact{contact.time, contact.is_at_start} << Text(", triangles ")
             << contact.pair;
}
std::ostream& operator<<(std::ostream& out, const MeshCast& cast) {
  return out << FirstContact{cast.time, cast.is_at_start} << Text(", triangles ") << cast.pair
             << Text(", point ", cast.point, ", normal ", cast.normal);
}
std::ostream& operator<<(std::ostream& out, const VolumeCast& cast) {
  return out << FirstContact{cast.time, cast.is_at_start}
             << Text(", triangle ", cast.triangle, ", point ", cast.point, ", normal ",
                     cast.normal);
}
std::ostream& operator<<(std::ostream& out, const RigidContact& contact) {
  if (contact.status == RigidStatus::Free) return out << "free";
  if (contact.status == RigidStatus::Hit)
    return out << Text("free up to ", contact.low, ", hit at ", contact.high);
  return out << Text("free up to ", contact.low)
             << (contact.is_out_of_budget ? ", out of budget" : ", then close");
}
std::ostream& operator<<(std::ostream& out, const MeshDistance& gap) {
  return out << Text("distance ", gap.distance, " from ", gap.point_a, " to ", gap.point_b,
                     ", triangles ")
             << gap.pair;
}
std::ostream& operator<<(std::ostream& out, const NearestPoint& nearest) {
  return out << Text("distance ", nearest.distance, " to ", nearest.point, " in triangle ",
                     nearest.triangle);
}
std::ostream& operator<<(std::ostream& out, const MeshHealth& health) {
  return out << Text(health.open_edges.size(), " open, ", health.non_manifold_edges.size(),
                     " non-manifold and ", health.turned_edges.size(), " turned edges, ",
                     health.degenerate_triangles.size(), " degenerate and ",
                     health.duplicate_triangles.size(), " duplicate triangles, ",
                     health.inside_out_parts.size(), " parts inside out, ",
                     health.self_intersections.size(), " self-intersections");
}
std::ostream& operator<<(std::ostream& out, const MeshContact& contact) {
  return out << Text("[depth ", contact.depth, ", normal ", contact.normal, ", from ",
                     contact.point_a, " to ", contact.point_b, "]");
}
std::ostream& operator<<(std::ostream& out, const MeshContacts& contacts) {
  return write_limited(out, contacts, "contacts");
}
std::ostream& operator<<(std::ostream& out, const SeparatingTranslation& separation) {
  return out << Text("apart after ", separation.distance, " along ", separation.direction);
}
std::ostream& operator<<(std::ostream& out, const VolumeFit& fit) {
  Text text(name_of(fit.type), " of ", fit.volume, " m^3 and ", fit.surface, " m^2");
  if (fit.empty_share) text.add(", empty share "), text.add(*fit.empty_share);
  if (fit.relative_volume) text.add(", relative volume "), text.add(*fit.relative_volume);
  return out << text;
}
std::ostream& operator<<(std::ostream& out, const MeshFit& fit) {
  out << (fit.enclosed_volume ? Text("encloses ", *fit.enclosed_volume, " m^3") : Text("open"));
  for (const VolumeFit& volume : fit.volumes)
    out << Text("; ") << volume;
  return out;
}
std::ostream& operator<<(std::ostream& out, const RayHit& hit) {
  out << Text("hit at ", hit.distance, ", point ", hit.point, ", normal ", hit.normal);
  return hit.triangle == kNoTriangle ? out : out << Text(", triangle ", hit.triangle);
}
std::ostream& operator<<(std::ostream& out, const FaultyEdge& edge) {
  return out << Text("edge ", edge.vertices[0], "-", edge.vertices[1], " of ", edge.triangle_count,
                     " triangles from ", edge.triangle);
}
std::ostream& operator<<(std::ostream& out, const DuplicateTriangle& triangle) {
  return out << Text("triangle ", triangle.triangle, " as ", triangle.earlier);
}
std::ostream& operator<<(std::ostream& out, const InsideOutPart& part) {
  return out << Text("part of ", part.triangle_count, " triangles from ", part.triangle,
                     ", inside ", part.depth);
}

std::ostream& operator<<(std::ostream& out, const Topology& topology) {
  return out << Text(topology.is_closed ? "closed" : "open", ", ", topology.welded_vertices,
                     " vertices, ", topology.components, " components, ", topology.boundary_edges,
                     " boundary edges, ", topology.degenerate_triangles, " degenerate and ",
                     topology.duplicate_triangles, " duplicate triangles");
}
std::ostream& operator<<(std::ostream& out, const MeshIntersection& common) {
  return out << Text(common.curves.size(), " curves, ", common.patches.size(), " patches, ",
                     common.touching_points.size(), " touching points: ", common.points.size(),
                     " points, ", common.segments.size(), " segments and ", common.polygons.size(),
                     " polygons of ", common.pairs.size(), " pairs");
}
std::ostream& operator<<(std::ostream& out, const Voxels& voxels) {
  return out << Text(std::uint64_t{voxels.size()}, " voxels of a ") << voxels.grid;
}
std::ostream& operator<<(std::ostream& out, const FreedomCertificate& certificate) {
  return out << Text("proof of ", certificate.steps.size(), " steps that ",
                     certificate.order_a.size(), " and ", certificate.order_b.size(),
                     " triangles stay further apart than ", certificate.clearance);
}
std::ostream& operator<<(std::ostream& out, const IntersectionPoint& point) {
  return out << Text("point ", point.position, " in ") << point.feature_a << Text(" and ")
             << point.feature_b;
}
std::ostream& operator<<(std::ostream& out, const IntersectionSegment& segment) {
  return out << Text("segment ", segment.from, "-", segment.to, " of ", segment.pair_count,
                     " pairs from ", segment.first_pair);
}
std::ostream& operator<<(std::ostream& out, const IntersectionCurve& curve) {
  return out << Text(curve.is_closed ? "closed" : "open", " curve of ", curve.segment_count,
                     " segments from ", curve.first_segment);
}
std::ostream& operator<<(std::ostream& out, const IntersectionPolygon& polygon) {
  Text text("polygon");
  for (std::uint32_t i = 0; i < polygon.corner_count; ++i)
    text.add(i == 0 ? " " : "-"), text.add(polygon.corners[i]);
  return out << text << Text(" of ", polygon.pair_count, " pairs from ", polygon.first_pair);
}
std::ostream& operator<<(std::ostream& out, const IntersectionPatch& patch) {
  return out << Text("patch of ", patch.polygon_count, " polygons from ", patch.first_polygon);
}
std::ostream& operator<<(std::ostream& out, const TouchingPoint& touching) {
  return out << Text("touching point ", touching.point, " of ", touching.pair_count, " pairs from ",
                     touching.first_pair);
}
std::ostream& operator<<(std::ostream& out, const FreedomStep& step) {
  out << step.kind;
  if (step.kind == FreedomStep::Kind::HalveTime) return out;
  return step.kind == FreedomStep::Kind::Plane ? out << Text(" across ", step.normal)
                                               : out << Text(" after ", step.count, " triangles");
}

}  // namespace graze
