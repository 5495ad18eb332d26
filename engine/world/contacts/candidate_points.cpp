// Finds the contacts over the faces, edges and corners of a mesh that a convex shape touches.

#include <graze/engine/world/contacts/last_touch.h>
#include <graze/engine/world/contacts/triangle_candidates.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/contact/point_name.h>
#include <graze/narrowphase/convex/core/contact_face.h>
#include <graze/narrowphase/convex/core/core_ray.h>
#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <cmath>

namespace graze {

using narrowphase::ContactPoint;
using narrowphase::Core;
using narrowphase::Parting;
using narrowphase::Vec3;

namespace {

// Of two points that belong together, one is the other moved along the way out, to this share of
// the shape's size.
constexpr double kAlong = 0x1p-20;

// A depth that is less than the greatest by no more than this share of the shape's size counts as
// the greatest.
constexpr double kSameDepth = 1e-6;

// Of last touches with several triangles another one counts if it is deeper by this share: a tenth
// of what law 15 leaves to depths.
constexpr double kSameTouch = 1e-4;

Parting parting_of(const TouchedTriangle& member) {
  Parting parting;
  parting.penetration.normal = -member.parting.exit.direction;
  parting.penetration.depth = std::max(member.parting.exit.depth, 0.0);
  return parting;
}

/// Return the features of an edge of a mesh, given by its ends, and of a corner.
std::uint64_t edge_feature(std::uint64_t low, std::uint64_t high) {
  return std::uint64_t{1} << 62 | ((low ^ (high * 0x9E3779B1u)) & 0x3fffffff) << 32;
}
std::uint64_t corner_feature(std::uint64_t vertex) {
  return std::uint64_t{1} << 63 | (vertex & 0x3fffffff) << 32;
}

/// True if a feature is that of a point of a shape, of any part of a round side.
bool is_of_point(std::uint64_t feature) {
  return (feature & 0xffffffff) == narrowphase::kPointFeature;
}

/// Adds a point of the mesh, and the point of the shape that is as deep along the normal.
void add_point(const Vec3& on_mesh, const Parting& parting, std::vector<ContactPoint>& found) {
  const Vec3 on_shape = on_mesh + parting.penetration.normal * parting.penetration.depth;
  found.push_back({on_shape, on_mesh, parting.penetration.normal, parting.penetration.depth,
                   narrowphase::kPointFeature, narrowphase::kPointFeature});
}

}  // namespace

Core edge_core(const Vec3& from, const Vec3& to) {
  Core core;
  core.kind = narrowphase::CoreKind::Segment;
  core.at = (from + to) * 0.5;
  core.axis[2] = unit_or(to - from, {0, 0, 1});
  core.axis[0] = any_normal_to(core.axis[2]);
  core.axis[1] = cross(core.axis[2], core.axis[0]);
  core.half = {0, 0, 0.5 * length(to - from)};
  core.bounding_radius = core.half.z;
  return core;
}

/// Adds the contacts of the shape's face and a triangle. Depths are the distances of their points,
/// which over faces that are only nearly at right angles to the exit may be more than the exit
/// clears.
void TriangleCandidates::add_over_face(const TouchedTriangle& face, const Parting& parting) {
  candidates_.found.clear();
  add_face_contact_points(bare(), face.triangle, bare(parting).penetration, candidates_.found,
                          candidates_.margin);
  const double most =
      parting.penetration.depth + kSameDepth * (core_.bounding_radius + core_.radius);
  std::erase_if(candidates_.found, [&](ContactPoint& touch) {
    touch.depth = std::max(dot(touch.point_a - touch.point_b, touch.normal), 0.0);
    return touch.depth > most;
  });
  take(face_feature(face.parting.triangle));
}

/// Adds contacts of faces that are nearly at right angles to the exit of an edge or a corner, as at
/// the rim of a table that a body leans on.
void TriangleCandidates::add_near_faces(const TouchedTriangle& member) {
  const Parting parting = parting_of(member);
  candidates_.found.clear();
  for (const TouchedTriangle& each : s_.all) {
    const Vec3* corner = each.triangle.corner;
    const Vec3 normal = unit_or(cross(corner[1] - corner[0], corner[2] - corner[0]), {0, 0, 1});
    if (dot(normal, member.parting.exit.direction) < kNearlyFacing) continue;
    add_over_face(each, parting);
  }
}

void TriangleCandidates::add_member(const TouchedTriangle& member) {
  const std::uint32_t index = member.parting.triangle;
  const int k = member.parting.which, next = (k + 1) % 3;
  const Parting parting = parting_of(member);
  candidates_.found.clear();
  switch (member.parting.feature) {
    case LeftFeature::Face:
      add_over_face(member, parting);
      break;
    case LeftFeature::Edge: {
      const std::uint32_t s = features_.vertex(index, k), t = features_.vertex(index, next);
      if (is_held(s) && is_held(t)) return;
      add_contact_points(bare(), edge_core(member.triangle.corner[k], member.triangle.corner[next]),
                         bare(parting), candidates_.found, candidates_.margin);
      // Beyond the end of this edge the body leaves another one.
      std::erase_if(candidates_.found, [&](const ContactPoint& touch) {
        const Vec3 off = touch.point_a - touch.point_b - touch.normal * touch.depth;
        return length(off) > kAlong * (core_.bounding_radius + core_.radius);
      });
      take(edge_feature(numbers_.vertex(std::min(s, t)), numbers_.vertex(std::max(s, t))));
      break;
    }
    case LeftFeature::Corner: {
      const std::uint32_t vertex = features_.vertex(index, k);
      if (is_held(vertex)) return;
      const Vec3& corner = member.triangle.corner[k];
      if (candidates_.margin > 0) {
        if (!add_before(corner, parting.penetration.normal)) return;
      } else {
        add_point(corner, parting, candidates_.found);
        if (!is_on_shape(candidates_.found.back().point_a)) return;
      }
      name_point(core_, member.triangle, candidates_.found.back());
      take(corner_feature(numbers_.vertex(vertex)));
      break;
    }
  }
}

/// Adds the shape's deepest point along the way out, if the face that it leaves is above that
/// point.
bool TriangleCandidates::add_deepest(const TouchedTriangle& member, std::uint64_t of_shape) {
  if (member.parting.feature != LeftFeature::Face) return false;
  const Parting parting = parting_of(member);
  const Vec3 deepest = rounded_support(core_, parting.penetration.normal);
  const Vec3 foot = deepest - parting.penetration.normal * parting.penetration.depth;
  const std::optional<std::uint32_t> met =
      features_.flat_triangle(member.parting.triangle, member.triangle, foot);
  if (!met) return false;
  candidates_.found.clear();
  add_point(foot, parting, candidates_.found);
  ContactPoint& touch = candidates_.found.back();
  touch.feature_a = of_shape;
  // A surface that goes on nearly flat is beside the plane, and the plane of a needle is beside its
  // tip.
  const bool is_member = *met == member.parting.triangle;
  if (!is_member || narrowphase::is_narrow(member.triangle)) {
    const Core triangle = is_member ? member.triangle : features_.placed_triangle(*met);
    const Vec3 on_mesh = nearest_on_triangle(triangle, foot);
    const double size = core_.bounding_radius + core_.radius;
    if (length(on_mesh - foot) > kOnSurface * size) {
      touch.point_a = deepest, touch.point_b = on_mesh;
      touch.depth = std::max(dot(deepest - on_mesh, touch.normal), 0.0);
    }
  }
  take(face_feature(*met));
  return true;
}

/// Adds the point in which the shape touches the triangles of a region last on the way out, if that
/// is deeper than what is there, or if there is nothing. So what parts them is the depth of a
/// contact where the deepest point lies beside them: past a rim, beyond the end of an edge, in a
/// valley.
bool TriangleCandidates::add_last_touch(const RegionMembers& region, double deepest,
                                        std::uint64_t of_shape) {
  const Parting parting = parting_of(region.speaker);
  const Vec3& out = parting.penetration.normal;
  const double margin = candidates_.margin;
  const double depth = parting.penetration.depth - margin;
  std::optional<LastTouch> last;
  std::uint32_t touched = 0;
  double least = std::max(deepest, 0.0) - margin;
  const auto try_member = [&](const TouchedTriangle& member) {
    const std::optional<LastTouch> found =
        last_touch(bare(), member.triangle, {-out, depth, least});
    if (!found || (last && found->way <= last->way)) return;
    last = found, touched = member.parting.triangle;
    least = found->way + kSameTouch * std::max(found->way + margin, 0.0);
  };
  // That beside the deepest point mostly is the last, and the others then are soon done with.
  const Vec3 foot = rounded_support(bare(), out) - out * depth;
  const auto off = [&](const TouchedTriangle& member) {
    return length(nearest_on_triangle(member.triangle, foot) - foot);
  };
  const TouchedTriangle* first = &region.members.front();
  double least_off = off(*first);
  for (const TouchedTriangle& member : region.members.subspan(1))
    if (const double other = off(member); other < least_off) first = &member, least_off = other;
  try_member(*first);
  for (const TouchedTriangle& member : region.members)
    if (&member != first) try_member(member);
  if (!last) return false;
  const double way = std::max(last->way + margin, 0.0);
  if (!(way > deepest)) return false;
  candidates_.found.clear();
  candidates_.found.push_back({last->on_body + out * margin, last->on_other, out, way, of_shape,
                               narrowphase::kPointFeature});
  take(face_feature(touched));
  // Of two points of one name the deeper stays.
  std::vector<ContactPoint>& list = candidates_.list;
  const ContactPoint& own = list.back();
  const auto is_of_its_name = [&](const ContactPoint& other) {
    return other.feature_a == own.feature_a && other.feature_b == own.feature_b;
  };
  const auto begin = list.begin() + static_cast<std::ptrdiff_t>(region.first);
  list.erase(std::remove_if(begin, list.end() - 1, is_of_its_name), list.end() - 1);
  return true;
}

/// Adds the nearest points of the triangle and a shape that touches it only by the margin, if they
/// are nearest along the way out.
void TriangleCandidates::add_nearest(const TouchedTriangle& member) {
  if (candidates_.margin == 0) return;
  const narrowphase::CoreGap gap = narrowphase::nearest(bare(), member.triangle);
  const double distance = gap.upper - bare().radius;
  const Parting parting = parting_of(member);
  const Vec3 between = unit_or(gap.point_b - gap.point_a, -parting.penetration.normal);
  if (!(distance > 0) || dot(between, parting.penetration.normal) < kNearlyFacing) return;
  candidates_.found.clear();
  add_apart(gap.point_a + between * bare().radius, gap.point_b, parting.penetration.normal);
  take(face_feature(member.parting.triangle));
}

/// Adds a point of each surface, which are apart but for the margin and need not lie along the
/// normal.
void TriangleCandidates::add_apart(const Vec3& on_shape, const Vec3& on_mesh, const Vec3& normal) {
  const double margin = candidates_.margin;
  const double depth = std::max(dot(on_shape - on_mesh, normal) + margin, 0.0);
  candidates_.found.push_back({on_shape + normal * margin, on_mesh, normal, depth,
                               narrowphase::kPointFeature, narrowphase::kPointFeature});
}

/// Adds a point of the mesh and the point where the shape ends before it along the normal. Returns
/// false if the line misses the shape, or ends more than the margin behind the point. Only pairs
/// with a margin come here, so that the shape is never a mesh's vertices, whose faces nobody knows:
/// those leave what encloses them, and a margin does not count there.
bool TriangleCandidates::add_before(const Vec3& on_mesh, const Vec3& normal) {
  const double beyond = dot(rounded_support(core_, normal) - on_mesh, normal);
  const Vec3 origin = on_mesh + normal * (beyond + core_.bounding_radius + core_.radius);
  const std::optional<narrowphase::CoreRayHit> hit = cast_ray(bare(), origin, -normal);
  if (!hit) return false;
  const double depth = dot(origin - normal * hit->distance - on_mesh, normal) + candidates_.margin;
  if (depth < 0) return false;
  candidates_.found.push_back({on_mesh + normal * depth, on_mesh, normal, depth,
                               narrowphase::kPointFeature, narrowphase::kPointFeature});
  return true;
}

/// Adds a contact of a shape and a triangle that graze each other: that the shape does not touch on
/// the way out, but for rounding. The nearest points that are found may be apart by more than that,
/// as for edges that are almost parallel.
void TriangleCandidates::add_grazing(const TouchedTriangle& member) {
  const Parting parting = parting_of(member);
  const Vec3& out = parting.penetration.normal;
  candidates_.found.clear();
  if (candidates_.margin > 0) {
    const narrowphase::CoreGap gap = narrowphase::nearest(bare(), member.triangle);
    const Vec3 between = unit_or(gap.point_b - gap.point_a, out);
    add_apart(gap.point_a + between * bare().radius, gap.point_b, out);
  } else {
    const narrowphase::CoreGap shared = narrowphase::nearest(core_, member.triangle);
    const Vec3& on_shape = core_.radius > 0 ? shared.point_b : shared.point_a;
    candidates_.found.push_back(
        {on_shape, shared.point_b, out, 0, narrowphase::kPointFeature, narrowphase::kPointFeature});
  }
  take(face_feature(member.parting.triangle));
}

/// Adds a contact along the shortest way on which the shape parts from a triangle alone.
void TriangleCandidates::add_alone(const TouchedTriangle& member) {
  using enum narrowphase::CoreKind;
  const Core& triangle = member.triangle;
  const Core& core = bare();
  const bool has_formula = candidates_.margin == 0 && (core.kind == Box || core.kind == Point) &&
                           !FacingFeatures::is_sliver(triangle);
  Parting parting = has_formula ? part_from_triangle(core, triangle)
                                : part(core, triangle, narrowphase::nearest(core, triangle));
  work_.penetration_tests += parting.is_asked;
  work_.penetration_failures += parting.is_failed;
  if (candidates_.margin > 0) sign_depth(core, triangle, parting);
  candidates_.found.clear();
  add_contact_points(core, triangle, parting, candidates_.found, candidates_.margin);
  take(face_feature(member.parting.triangle));
}

/// True if a point that should be on the shape's surface is there.
bool TriangleCandidates::is_on_shape(const Vec3& point) const {
  Core core;
  core.at = point;
  const double size = core_.bounding_radius + core_.radius;
  return narrowphase::nearest(core_, core).upper - core_.radius <= kOnSurface * size;
}

void TriangleCandidates::take(std::uint64_t of_mesh) {
  for (ContactPoint& touch : candidates_.found) {
    touch.feature_b = of_mesh | (touch.feature_b & 0xffffffff);
    candidates_.list.push_back(touch);
  }
}

/// Removes doubles: points over an edge that two triangles share are found with both, and that of
/// the first stays.
void TriangleCandidates::drop_doubles(std::size_t first) {
  std::vector<ContactPoint>& list = candidates_.list;
  if (list.size() - first > 64) return;  // reduce() leaves the farthest
  constexpr double kOnePoint = 1e-9;
  const double within = kOnePoint * (core_.bounding_radius + core_.radius);
  std::size_t kept = first;
  for (std::size_t i = first; i < list.size(); ++i) {
    const auto is_same = [&](const ContactPoint& other) {
      const bool is_one_feature = is_of_point(other.feature_a) &&
                                  list[i].feature_a == other.feature_a &&
                                  list[i].feature_b == other.feature_b;
      return is_one_feature || largest(other.point_b - list[i].point_b) <= within;
    };
    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
    if (std::any_of(begin, list.begin() + static_cast<std::ptrdiff_t>(kept), is_same)) continue;
    list[kept++] = list[i];
  }
  list.resize(kept);
}

/// True if a vertex is of a face that counts: contacts at its edges and corners are found with that
/// face.
bool TriangleCandidates::is_held(std::uint32_t vertex) const {
  return std::binary_search(s_.held.begin(), s_.held.end(), vertex);
}

}  // namespace graze
