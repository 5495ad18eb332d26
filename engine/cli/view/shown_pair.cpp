#include <graze/engine/cli/view/shown_pair.h>

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/mesh_intersection.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace graze::cli {
namespace {

double as_number(std::size_t count) {
  return static_cast<double>(count);
}

ViewFrame frame_of(const PictureWords& words) {
  return {.label = words.label, .note = words.note, .is_apart = words.is_apart};
}

void begin(const ViewFrame& frame, ShownPage& page) {
  page.view.begin_frame(frame);
  ++page.frames;
  if (frame.state == ViewState::Touching) ++page.touching;
}

void add_curves(const MeshIntersection& intersection, View& view) {
  const auto at = [&](std::uint32_t point) { return intersection.points[point].position; };
  for (const IntersectionCurve& curve : intersection.curves) {
    std::vector<Eigen::Vector3d> points;
    for (const IntersectionSegment& segment : intersection.segments_of(curve)) {
      // Segments of a curve lie end to end, whichever way each is told.
      if (points.empty() || points.back() != at(segment.from)) points.push_back(at(segment.from));
      points.push_back(at(segment.to));
    }
    view.add_curve(points);
  }
  for (const IntersectionPolygon& polygon : intersection.polygons) {
    std::vector<Eigen::Vector3d> points;
    for (std::uint32_t k = 0; k <= polygon.corner_count; ++k)
      points.push_back(at(polygon.corners[k % polygon.corner_count]));
    view.add_curve(points);
  }
}

void mark(const TrianglePairs& pairs, const ShownBodies& bodies, View& view) {
  std::vector<std::uint32_t> of_a, of_b;
  for (const TrianglePair& pair : pairs) {
    of_a.push_back(pair.a);
    of_b.push_back(pair.b);
  }
  view.mark_triangles(bodies.a, of_a);
  view.mark_triangles(bodies.b, of_b);
}

/// Adds a square across the middle of the shortest way between two bodies, as large as the smaller
/// one.
void add_plane_between(const Eigen::Vector3d& point_a, const Eigen::Vector3d& point_b,
                       const Aabb& box_a, const Aabb& box_b, View& view) {
  const auto radius = [](const Aabb& box) { return (box.max / 2 - box.min / 2).stableNorm(); };
  const double extent = std::min(radius(box_a), radius(box_b));
  const Eigen::Vector3d normal = point_b - point_a, middle = point_a / 2 + point_b / 2;
  if (!normal.isZero(0) && normal.allFinite() && std::isfinite(extent) && extent > 0)
    view.add_plane({middle, normal, extent});
}

/// Returns the least of all vertices along a direction from a point.
double least_along(const PlacedMeshView& mesh, const Eigen::Vector3d& from,
                   const Eigen::Vector3d& direction) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& vertex : mesh.mesh.vertices())
    least = std::min(least, (mesh.pose * vertex - from).dot(direction));
  return least;
}

/// Adds the plane across the gap, if it keeps all of the two meshes apart: others wind around each
/// other.
void add_plane_between(const PlacedMeshView& a, const PlacedMeshView& b, const MeshDistance& gap,
                       View& view) {
  const Eigen::Vector3d normal = (gap.point_b - gap.point_a).stableNormalized();
  const Eigen::Vector3d middle = gap.point_a / 2 + gap.point_b / 2;
  if (least_along(a, middle, -normal) > 0 && least_along(b, middle, normal) > 0)
    add_plane_between(gap.point_a, gap.point_b, a.mesh.bounds(), b.mesh.bounds(), view);
}

bool is_convex(const Shape& shape) {
  return shape.kind() != ShapeKind::Mesh && shape.kind() != ShapeKind::HeightField;
}

template <typename Contacts>
double deepest(const Contacts& contacts) {
  double most = 0;
  for (const auto& contact : contacts)
    most = std::max(most, contact.depth);
  return most;
}

template <typename Contacts>
void add_contacts(const Contacts& contacts, View& view) {
  for (const auto& contact : contacts)
    view.add_contact(contact.point, contact.normal, std::max(0.0, contact.depth));
}

void place(const ShownBodies& bodies, const Pose& pose_a, const Pose& pose_b, View& view) {
  view.place(bodies.a, pose_a);
  view.place(bodies.b, pose_b);
}

}  // namespace

void show_pair(const PlacedMeshView& a, const PlacedMeshView& b, const ShownBodies& bodies,
               const PictureWords& words, ShownPage& page) {
  ViewFrame frame = frame_of(words);
  const TrianglePairs pairs = find_triangle_pairs(a, b);
  if (pairs.empty()) {
    const MeshDistance gap = distance(a, b);
    frame.state = ViewState::Clear;
    frame.facts = {{"gap", gap.distance, true}};
    begin(frame, page);
    place(bodies, a.pose, b.pose, page.view);
    page.view.add_gap(gap.point_a, gap.point_b, gap.distance);
    add_plane_between(a, b, gap, page.view);
    return;
  }
  const MeshContacts contacts = find_contacts(a, b);
  frame.state = ViewState::Touching;
  frame.facts = {{"pairs of triangles", as_number(pairs.size())},
                 {"contacts", as_number(contacts.size())},
                 {"deepest", deepest(contacts), true}};
  begin(frame, page);
  place(bodies, a.pose, b.pose, page.view);
  mark(pairs, bodies, page.view);
  add_curves(find_intersection(a, b), page.view);
  add_contacts(contacts, page.view);
}

void show_pair(const PlacedShapeView& a, const PlacedShapeView& b, const ShownBodies& bodies,
               const PictureWords& words, ShownPage& page) {
  ViewFrame frame = frame_of(words);
  Manifold manifold;
  std::optional<ShapeDistance> gap;
  try {
    if (intersects(a, b)) {
      manifold = find_contacts(a, b);
      frame.state = ViewState::Touching;
      frame.facts = {{"contacts", as_number(manifold.size())},
                     {"deepest", deepest(manifold), true}};
    } else {
      gap = distance(a, b);
      frame.state = ViewState::Clear;
      frame.facts = {{"gap", gap->distance, true}};
    }
  } catch (const UnsupportedPairError& error) {
    frame.state = ViewState::Unknown;
    frame.note += (frame.note.empty() ? "" : " ") + std::string(error.what());
  }
  begin(frame, page);
  place(bodies, a.pose, b.pose, page.view);
  add_contacts(manifold, page.view);
  if (!gap) return;
  page.view.add_gap(gap->point_a, gap->point_b, gap->distance);
  if (is_convex(a.shape) && is_convex(b.shape))
    add_plane_between(gap->point_a, gap->point_b, bounding_aabb(a), bounding_aabb(b), page.view);
}

}  // namespace graze::cli
