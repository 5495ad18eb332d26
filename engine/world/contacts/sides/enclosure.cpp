#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/world/contacts/local_parting.h>
#include <graze/engine/world/contacts/sides/body_side.h>
#include <graze/engine/world/contacts/sides/corner_ways.h>
#include <graze/engine/world/contacts/sides/enclosure.h>
#include <graze/engine/world/contacts/triangle_candidates.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/mesh_descent.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace graze {

using narrowphase::Core;
using narrowphase::Vec3;

namespace {

// Lengths below this share of the body's size or of the scale count as 0.
constexpr double kNegligible = 1e-9;

// A body that has left by a feature touches it, to this share of the body's size L. An exit along
// the arc of an edge is the least to e = kFacingTolerance L. Its slope over the angle is how far
// beside the edge the body then touches the plane through it. Near the least, a slope s costs at
// least s^2 / (2 c), where c bounds the second derivative: for contours no flatter than the body is
// large c is at most 2 L, and s at most sqrt(4 e L) = 6.4e-4 L. What is flatter leans from the
// plane by as much less, and of polytopes the corners alone are visited. Exits of corners and faces
// are right to rounding. The rest is for searches that end by kMostSupports.
constexpr double kMeeting = 1e-3;

// Contacts are as deep as the way out is long, to the three thousandths that law 15 allows.
constexpr double kDeepShare = 0.997;

}  // namespace

bool Enclosure::holds() const {
  if (body_.shape.kind() == ShapeKind::HalfSpace) return false;  // no finite exit leads out
  switch (sides_.kind()) {
    case Sides::Surface:
      return false;
    case Sides::Solid:
      return is_inside();
    case Sides::OneSided:
      return is_behind();
  }
  return false;
}

/// The surfaces share no point, so that one point of each connected part decides.
bool Enclosure::is_inside() const {
  if (const Mesh* body = body_.shape.as<Mesh>()) {
    const std::span<const std::uint32_t> of_parts = body->component_vertices();
    return std::any_of(of_parts.begin(), of_parts.end(), [&](std::uint32_t vertex) {
      return contains(mesh_, narrowphase::place(body_.pose, body->vertices()[vertex]), &work_);
    });
  }
  return contains(mesh_, inner_point(body_), &work_);
}

bool Enclosure::is_behind() const {
  const ShapeDistance nearest = distance(body_, {mesh_.mesh, mesh_.pose}, &work_);
  return nearest.distance <= sides_.thickness() && graze::is_behind(body_, mesh_, nearest, work_) &&
         !is_beside(nearest.point_b);
}

/// True if the surface ends at its point that is nearest to the body, and no part of the body is
/// behind it there: it is wholly beyond the border, so that the way straight ahead has no length.
bool Enclosure::is_beside(const Eigen::Vector3d& nearest) const {
  if (mesh_.mesh.topology().is_closed) return false;
  static thread_local Scratch scratch;  // no pair is looked at within another
  const Eigen::Vector3d origin = this->origin();
  const Core core = this->core(origin, scratch);
  const FacingFeatures features(mesh_, to_vec3(origin));
  const Vec3 at = to_vec3(nearest) - to_vec3(origin);
  const double scale = largest(to_vec3(nearest)) + largest(to_vec3(origin)) + length(at);
  const Sphere around{nearest, kNegligible * scale};
  const TriangleList found = find_triangles(mesh_, around, {}, &work_);
  return std::any_of(found.triangles.begin(), found.triangles.end(), [&](std::uint32_t index) {
    const Core triangle = features.placed_triangle(index);
    if (FacingFeatures::is_sliver(triangle)) return false;
    const Vec3 normal = LocalPartings::normal_of(triangle);
    for (int k = 0; k < 3; ++k) {
      const Vec3& from = triangle.corner[k];
      const Vec3 along = unit_or(triangle.corner[(k + 1) % 3] - from, {0, 0, 0});
      if (length(cross(along, at - from)) > around.radius || features.across(index, k)) continue;
      const Vec3 ahead = unit_or(cross(along, normal), normal);
      if (dot(ahead, from - rounded_support(core, -ahead)) > 0) continue;
      // Where an edge ends in the middle of another one the surface goes on beyond it.
      const bool goes_on =
          std::any_of(found.triangles.begin(), found.triangles.end(), [&](std::uint32_t other) {
            const Core beyond = features.placed_triangle(other);
            return std::any_of(
                std::begin(beyond.corner), std::end(beyond.corner),
                [&](const Vec3& corner) { return dot(ahead, corner - from) > around.radius; });
          });
      if (!goes_on) return true;
    }
    return false;
  });
}

/// Returns a point near the body: tolerances are shares of its size, wherever the frame of a mesh
/// lies.
Eigen::Vector3d Enclosure::origin() const {
  const Mesh* body = body_.shape.as<Mesh>();
  if (body == nullptr) return middle_of(body_.shape, body_.pose);
  const Aabb& box = body->bounds();
  return narrowphase::place(body_.pose, box.min / 2 + box.max / 2);
}

Core Enclosure::core(const Eigen::Vector3d& origin, Scratch& scratch) const {
  const Mesh* body = body_.shape.as<Mesh>();
  if (body == nullptr) return core_of(body_.shape, body_.pose, origin);
  Core core;
  core.kind = narrowphase::CoreKind::Points;
  scratch.points.clear();
  // A vertex that no triangle has is no part of the body.
  scratch.is_taken.assign(body->vertices().size(), false);
  for (const TriangleIndices& triangle : body->triangles()) {
    for (const std::uint32_t index : triangle) {
      if (scratch.is_taken[index]) continue;
      scratch.is_taken[index] = true;
      const Eigen::Vector3d& vertex = body->vertices()[index];
      scratch.points.push_back(to_vec3(narrowphase::place(body_.pose, vertex)) - to_vec3(origin));
      core.bounding_radius = std::max(core.bounding_radius, length(scratch.points.back()));
    }
  }
  core.points = scratch.points.data(), core.point_count = scratch.points.size();
  return core;
}

/// Finds the exits through triangles.
class Enclosure::Exits {
 public:
  Exits(const Core& core, const PlacedMeshView& mesh, Sides sides, const Eigen::Vector3d& origin)
      : core_(core),
        sides_(sides),
        features_(mesh, to_vec3(origin)),
        partings_(core, features_),
        allowance_(kNegligible * (core.bounding_radius + core.radius)),
        corner_ways_(core, mesh, to_vec3(origin), features_, allowance_) {}

  /// Returns the exit through the triangle, if one leads out there: the shortest, or else the one
  /// through its face. At the end of a face, in a hollow, an edge may name the next face's shorter
  /// exit, which does not lead out.
  std::optional<LocalParting> through(std::uint32_t index, const Core& triangle) {
    if (FacingFeatures::is_sliver(triangle)) return std::nullopt;
    const Vec3 normal = LocalPartings::normal_of(triangle);
    const Vec3 deepest = support(core_, -normal);
    if (is_bare()) corner_ways_.see(index, deepest);
    const LocalParting parting = partings_.of(index, triangle, normal, deepest);
    if (leads_out(parting, triangle)) return parting;
    if (parting.feature == LeftFeature::Face) return std::nullopt;
    const LocalParting past_face = past_face_of(index, triangle);
    if (leads_out(past_face, triangle)) return past_face;
    return std::nullopt;
  }

  /// Returns the shortest exit past a corner of the triangles that were asked about, if it is below
  /// the limit and the partings through these did not know of it.
  std::optional<LocalParting> past_corner(double limit) {
    if (!is_bare()) return std::nullopt;
    return corner_ways_.shortest(limit);
  }

  /// Offers the triangle, which is no sliver, if the body leaves it by that exit.
  void offer(TriangleCandidates& found, std::uint32_t index, const Core& triangle,
             const narrowphase::Exit& sought) const {
    if (is_same(partings_.of(index, triangle).exit, sought)) return found.offer(index, triangle);
    const LocalParting past_face = past_face_of(index, triangle);
    if (is_same(past_face.exit, sought)) return found.offer(past_face, triangle);
    for (const CornerWays::Way& way : corner_ways_.found()) {
      if (!is_same(way.exit, sought)) continue;
      for (int k = 0; k < 3; ++k) {
        if (features_.vertex(index, k) == way.vertex)
          return found.offer({index, way.exit, LeftFeature::Corner, k}, triangle);
      }
    }
  }

  /// Returns the exit through the face of a triangle that is no sliver.
  LocalParting past_face_of(std::uint32_t index, const Core& triangle) const {
    const Vec3 normal = LocalPartings::normal_of(triangle);
    const Vec3 last = rounded_support(core_, -normal);
    return {index, {normal, dot(normal, triangle.corner[0] - last)}};
  }

  /// Returns the exit through the face of a triangle, no sliver, that is no farther than the
  /// nearest: for where none leads out. Where triangles share the nearest point, the shortest; the
  /// order of the triangles decides only between those that are as long.
  std::optional<LocalParting> past_nearest(MeshDescent& descent, double distance) const {
    const double within = distance + allowance_;
    std::optional<LocalParting> best;
    descent.for_each_within([&] { return within; },
                            [&](std::uint32_t index) {
                              const Core triangle = descent.triangle(index);
                              if (FacingFeatures::is_sliver(triangle) ||
                                  gap_of_sets(core_, triangle, within).distance > within)
                                return bvh::Walk::Continue;
                              const LocalParting past_face = past_face_of(index, triangle);
                              if (!best || is_before(past_face, *best)) best = past_face;
                              return bvh::Walk::Continue;
                            });
    return best;
  }

 private:
  /// Orders exits: those that lead the body forward first, the shortest of them first.
  static bool is_before(const LocalParting& s, const LocalParting& t) {
    const bool is_forward = s.exit.depth > 0;
    if (is_forward != (t.exit.depth > 0)) return is_forward;
    if (s.exit.depth != t.exit.depth) return std::abs(s.exit.depth) < std::abs(t.exit.depth);
    return s.triangle < t.triangle;
  }

  /// True if partings do not know the faces of the body, and so none that a corner leaves by.
  bool is_bare() const {
    return core_.kind == narrowphase::CoreKind::Points && core_.hull == nullptr;
  }

  bool is_same(const narrowphase::Exit& exit, const narrowphase::Exit& sought) const {
    return is_one_direction(exit.direction, sought.direction) &&
           std::abs(exit.depth - sought.depth) <= allowance_;
  }

  /// True if an exit leads out of the solid. Past a face it does if the body's last point leaves
  /// through that face or a flat one next to it; past an edge that names a face, likewise; past
  /// another edge or a corner, if the body touches that feature in the end.
  bool leads_out(const LocalParting& parting, const Core& triangle) const {
    const narrowphase::Exit& exit = parting.exit;
    if (!(exit.depth > 0)) return false;
    const auto leaves = [&](std::uint32_t index, const Core& face) {
      const Vec3 left = rounded_support(core_, -exit.direction) + exit.direction * exit.depth;
      if (features_.flat_triangle(index, face, left)) return true;
      // A body that is flat there has many last points, of which rounding names one. It may be
      // past an edge where others are on the face.
      return features_.falls_back(index, face, left) && gap_once_left(exit, face) <= allowance_;
    };
    if (parting.feature == LeftFeature::Face) return leaves(parting.triangle, triangle);
    if (parting.feature == LeftFeature::Corner) {
      if (sides_ == Sides::OneSided &&
          is_at_border(features_.vertex(parting.triangle, parting.which)))
        return true;
      narrowphase::Core corner;
      corner.at = triangle.corner[parting.which];
      return meets(exit, corner);
    }
    const std::optional<std::uint32_t> next = features_.across(parting.triangle, parting.which);
    if (!next) return true;
    const Core beyond = features_.placed_triangle(*next);
    if (FacingFeatures::is_sliver(beyond)) return true;
    if (is_one_direction(exit.direction, LocalPartings::normal_of(beyond)))
      return leaves(*next, beyond);
    const int k = parting.which;
    return meets(exit, edge_core(triangle.corner[k], triangle.corner[(k + 1) % 3]));
  }

  /// True if the surface ends at a vertex: what is behind it leaves straight ahead there, and need
  /// not touch it.
  bool is_at_border(std::uint32_t vertex) const {
    const std::span<const std::uint32_t> fan = features_.fan(vertex);
    return std::any_of(fan.begin(), fan.end(), [&](std::uint32_t index) {
      for (int k = 0; k < 3; ++k) {
        const bool has_it =
            features_.vertex(index, k) == vertex || features_.vertex(index, (k + 1) % 3) == vertex;
        if (has_it && !features_.across(index, k)) return true;
      }
      return false;
    });
  }

  /// True if the body, once it has left, touches the feature that it left by, and is not beside it.
  bool meets(const narrowphase::Exit& exit, const Core& feature) const {
    return gap_once_left(exit, feature) <= kMeeting * (core_.bounding_radius + core_.radius);
  }

  double gap_once_left(const narrowphase::Exit& exit, const Core& feature) const {
    Core moved = core_;
    moved.at = moved.at + exit.direction * exit.depth;
    return gap_of_sets(moved, feature).distance;
  }

  const Core& core_;
  Sides sides_;
  FacingFeatures features_;
  LocalPartings partings_;
  double allowance_;
  CornerWays corner_ways_;
};

void Enclosure::add(ContactCandidates& candidates) const {
  static thread_local Scratch scratch;  // no pair is looked at within another
  candidates.origin = origin();
  const Core core = this->core(candidates.origin, scratch);
  MeshDescent descent(mesh_, core, candidates.origin, work_);
  Exits exits(core, mesh_, sides_.kind(), candidates.origin);
  LocalParting best{0, {{0, 0, 1}, std::numeric_limits<double>::infinity()}};
  std::uint32_t nearest = 0;
  double nearest_distance = std::numeric_limits<double>::infinity();
  double counted = nearest_distance;  // the length that counts for the best exit
  const auto limit = [&] {
    return sides_.kind() == Sides::OneSided ? std::min(counted, sides_.thickness()) : counted;
  };
  descent.for_each_within(limit, [&](std::uint32_t index) {
    const Core triangle = descent.triangle(index);
    const double distance = gap_of_sets(core, triangle, nearest_distance).distance;
    ++work_.convex_tests;
    const bool is_tie = distance == nearest_distance && index < nearest;
    if (distance < nearest_distance || is_tie) nearest_distance = distance, nearest = index;
    const std::optional<LocalParting> parting = exits.through(index, triangle);
    if (!parting) return bvh::Walk::Continue;
    // An exit that leads past a border may be shorter than the gap to its triangle. It then counts
    // as long as the gap, or the tree would decide which exit ends the walk first.
    double bounded = parting->exit.depth;
    if (bounded < distance) bounded = std::max(bounded, gap_of_sets(core, triangle).distance);
    const bool is_as_short = bounded == counted && index < best.triangle;
    if (bounded < counted || is_as_short) best = *parting, counted = bounded;
    return bvh::Walk::Continue;
  });
  if (!std::isfinite(counted)) best = exits.past_nearest(descent, nearest_distance).value_or(best);
  const double longest = best.exit.depth > 0 ? std::min(counted, best.exit.depth) : counted;
  if (const auto past_corner = exits.past_corner(longest))
    best = *past_corner, counted = past_corner->exit.depth;
  TriangleCandidates found(core, mesh_, candidates, work_);
  if (std::isfinite(counted)) {
    descent.for_each_within([&] { return counted; },
                            [&](std::uint32_t index) {
                              const Core triangle = descent.triangle(index);
                              if (FacingFeatures::is_sliver(triangle)) return bvh::Walk::Continue;
                              exits.offer(found, index, triangle, best.exit);
                              return bvh::Walk::Continue;
                            });
    // An exit that leads past a border may be shorter than the gap to its triangle.
    if (!found.has_touched()) found.offer(best, descent.triangle(best.triangle));
  } else if (std::isfinite(best.exit.depth)) {
    found.offer(best, descent.triangle(best.triangle));
  } else {
    found.offer(nearest, descent.triangle(nearest));  // only slivers are as near
  }
  found.finish();
  if (std::isfinite(best.exit.depth))
    leave_by(best.exit, core, descent.triangle(best.triangle), candidates);
}

/// A body that leaves without touching anything on its way, as from behind a border, is as deep as
/// its way is long: its only contacts are those that say that it grazes the surface.
void Enclosure::leave_by(const narrowphase::Exit& exit, const Core& core, const Core& triangle,
                         ContactCandidates& candidates) {
  std::vector<narrowphase::ContactPoint>& list = candidates.list;
  const double least = kDeepShare * exit.depth;
  const bool is_deep = std::any_of(list.begin(), list.end(), [&](const auto& contact) {
    return contact.depth > 0 && contact.depth >= least;
  });
  if (is_deep || list.empty() || !(exit.depth > 0)) return;
  list.resize(1), candidates.ends.assign(1, 1);
  narrowphase::ContactPoint& contact = list.front();
  contact.normal = -exit.direction;
  contact.depth = exit.depth;
  contact.point_a = rounded_support(core, contact.normal);
  contact.point_b =
      narrowphase::nearest_on_triangle(triangle, contact.point_a + exit.direction * exit.depth);
}

}  // namespace graze
