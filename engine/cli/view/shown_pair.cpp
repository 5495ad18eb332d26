#include <graze/engine/cli/view/shown_pair.h>

#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/mesh_intersection.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
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
  if (gap) page.view.add_gap(gap->point_a, gap->point_b, gap->distance);
}

}  // namespace graze::cli
