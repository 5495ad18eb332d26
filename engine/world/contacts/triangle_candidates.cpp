#include <graze/engine/world/contacts/triangle_candidates.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/core/core_ray.h>
#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>

namespace graze {

using narrowphase::ContactPoint;
using narrowphase::Core;
using narrowphase::Parting;
using narrowphase::Vec3;

namespace {

// Of points that belong together the one is the other moved along the way out, to this share of the
// shape's size; and those on its surface are there to that.
constexpr double kAlong = 0x1p-20;
constexpr double kOnSurface = 0x1p-36;

// A depth that lacks less than this share of the shape's size is the greatest.
constexpr double kSameDepth = 1e-6;

Parting parting_of(const TouchedTriangle& member) {
  Parting parting;
  parting.penetration.normal = -member.parting.exit.direction;
  parting.penetration.depth = std::max(member.parting.exit.depth, 0.0);
  return parting;
}

Core segment(const Vec3& from, const Vec3& to) {
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

/// What an edge of a mesh, by its ends, and a corner are called in features.
std::uint64_t edge_feature(std::uint64_t low, std::uint64_t high) {
  return std::uint64_t{1} << 62 | ((low ^ (high * 0x9E3779B1u)) & 0x3fffffff) << 32;
}
std::uint64_t corner_feature(std::uint64_t vertex) {
  return std::uint64_t{1} << 63 | (vertex & 0x3fffffff) << 32;
}

/// One point of the mesh, and that of the shape so deep along the normal.
void add_point(const Vec3& on_mesh, const Parting& parting, std::vector<ContactPoint>& found) {
  const Vec3 on_shape = on_mesh + parting.penetration.normal * parting.penetration.depth;
  found.push_back({on_shape, on_mesh, parting.penetration.normal, parting.penetration.depth,
                   narrowphase::kPointFeature, narrowphase::kPointFeature});
}

}  // namespace

TriangleCandidates::Scratch& TriangleCandidates::scratch() {
  static thread_local Scratch kept;  // no pair is looked at within another
  return kept;
}

TriangleCandidates::TriangleCandidates(const Core& core, const PlacedMeshView& mesh,
                                       ContactCandidates& candidates, Work& work)
    : core_(core),
      candidates_(candidates),
      features_(mesh, to_vec3(candidates.origin)),
      numbers_(numbers_of(mesh.mesh)),
      partings_(core, features_),
      work_(work),
      s_(scratch()) {
  if (candidates.margin > 0) {
    bare_ = core;
    bare_->radius -= candidates.margin;
  }
  s_.touched.clear(), s_.slivers.clear();
}

void TriangleCandidates::add(std::uint32_t index, const Core& triangle) {
  if (candidates_.margin > 0 && is_behind(triangle)) return;
  PairStatus status{};
  ++work_.convex_tests;
  if (!are_apart(core_, triangle, status)) offer(index, triangle);
}

/// How it parts without the margin, by a depth that may be negative.
Parting TriangleCandidates::bare(Parting parting) const {
  parting.penetration.depth -= candidates_.margin;
  return parting;
}

/// Whether the shape itself is wholly behind the triangle's plane: it does not touch the triangle,
/// and what is near to it from behind is not led through it.
bool TriangleCandidates::is_behind(const Core& triangle) const {
  if (FacingFeatures::is_sliver(triangle)) return false;
  const Vec3 normal = LocalPartings::normal_of(triangle);
  return dot(rounded_support(bare(), normal) - triangle.corner[0], normal) < 0;
}

/// A triangle that the shape touches.
void TriangleCandidates::offer(std::uint32_t index, const Core& triangle) {
  if (FacingFeatures::is_sliver(triangle)) {
    s_.slivers.push_back({{index, {}, LeftFeature::Face, 0}, triangle, 0, 0});
  } else {
    s_.touched.push_back({partings_.of(index, triangle), triangle, 0, 0});
  }
}

void TriangleCandidates::finish() {
  // Whatever the order in which a tree has them.
  const auto by_number = [](const TouchedTriangle& s, const TouchedTriangle& t) {
    return s.parting.triangle < t.parting.triangle;
  };
  std::sort(s_.touched.begin(), s_.touched.end(), by_number);
  std::sort(s_.slivers.begin(), s_.slivers.end(), by_number);
  // Where slivers alone are touched, there is nothing that their normals could contradict.
  if (s_.touched.empty()) return part_from_slivers();
  const double size = core_.bounding_radius + core_.radius;
  s_.all = s_.touched;
  s_.regions.select(s_.touched, size, [&](const Vec3& translation, const Core& triangle) {
    Core moved = core_;
    moved.at = moved.at + translation;
    PairStatus status{};
    ++work_.convex_tests;
    return are_apart(moved, triangle, status);
  });
  const std::uint32_t regions = s_.regions.connect(s_.touched, features_);
  std::size_t at = 0;
  for (std::uint32_t region = 0; region < regions; ++region) {
    const std::size_t first = at;
    while (at < s_.touched.size() && s_.touched[at].region == region)
      ++at;
    add_region(std::span(s_.touched).subspan(first, at - first));
  }
}

std::uint64_t TriangleCandidates::face_feature(std::uint32_t triangle) const {
  return std::uint64_t{numbers_.triangle(triangle)} << 32;
}

void TriangleCandidates::part_from_slivers() {
  for (const TouchedTriangle& each : s_.slivers)
    add_alone(each);
  candidates_.end_region();
}

void TriangleCandidates::add_region(std::span<const TouchedTriangle> members) {
  s_.held.clear();
  for (const TouchedTriangle& member : members) {
    if (member.parting.feature != LeftFeature::Face) continue;
    for (int k = 0; k < 3; ++k)
      s_.held.push_back(features_.vertex(member.parting.triangle, k));
  }
  std::sort(s_.held.begin(), s_.held.end());
  const std::size_t before = candidates_.list.size();
  const TouchedTriangle& speaker = speaker_of(members);
  if (s_.held.empty()) add_near_faces(speaker);
  for (const TouchedTriangle& member : members)
    add_member(member);
  double most = -1;
  for (std::size_t i = before; i < candidates_.list.size(); ++i)
    most = std::max(most, candidates_.list[i].depth);
  const double allowance = kSameDepth * (core_.bounding_radius + core_.radius);
  // What the corners of a face leave out, above all of a round one, is the deepest point itself.
  if (speaker.parting.exit.depth - most > allowance && !add_deepest(speaker)) add_nearest(speaker);
  if (candidates_.list.size() == before) add_beside(speaker);
  drop_doubles(before);
  candidates_.end_region();
}

/// Of the shape's face and a triangle. Depths are what lies between the points, which over faces
/// that are only nearly at right angles to the way may be more than the way leaves.
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

/// Where an edge or a corner says how to part, as at the rim of a table that a body leans on,
/// faces that are nearly at right angles to that way have contacts, too.
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
      add_contact_points(bare(), segment(member.triangle.corner[k], member.triangle.corner[next]),
                         bare(parting), candidates_.found, candidates_.margin);
      // Beyond the end of this edge another is left.
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
      take(corner_feature(numbers_.vertex(vertex)));
      break;
    }
  }
}

/// The shape's deepest point along the way out, if the face that it leaves is above it.
bool TriangleCandidates::add_deepest(const TouchedTriangle& member) {
  if (member.parting.feature != LeftFeature::Face) return false;
  const Parting parting = parting_of(member);
  const Vec3 deepest = rounded_support(core_, parting.penetration.normal);
  const Vec3 foot = deepest - parting.penetration.normal * parting.penetration.depth;
  const std::optional<std::uint32_t> met =
      features_.flat_triangle(member.parting.triangle, member.triangle, foot);
  if (!met) return false;
  candidates_.found.clear();
  add_point(foot, parting, candidates_.found);
  // A surface that goes on nearly flat is beside the plane, and a needle's plane beside its tip.
  const bool is_member = *met == member.parting.triangle;
  if (!is_member || narrowphase::is_narrow(member.triangle)) {
    const Core triangle = is_member ? member.triangle : features_.placed_triangle(*met);
    const Vec3 on_mesh = nearest_on_triangle(triangle, foot);
    const double size = core_.bounding_radius + core_.radius;
    ContactPoint& touch = candidates_.found.back();
    if (length(on_mesh - foot) > kOnSurface * size) {
      touch.point_a = deepest, touch.point_b = on_mesh;
      touch.depth = std::max(dot(deepest - on_mesh, touch.normal), 0.0);
    }
  }
  take(face_feature(*met));
  return true;
}

/// Of a shape that is apart from the triangle, but for the margin, the nearest points, if they are
/// so along the way out.
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

/// A point of each surface, apart but for the margin, that need not lie along the normal.
void TriangleCandidates::add_apart(const Vec3& on_shape, const Vec3& on_mesh, const Vec3& normal) {
  const double margin = candidates_.margin;
  const double depth = std::max(dot(on_shape - on_mesh, normal) + margin, 0.0);
  candidates_.found.push_back({on_shape + normal * margin, on_mesh, normal, depth,
                               narrowphase::kPointFeature, narrowphase::kPointFeature});
}

/// A point of the mesh and where the shape ends before it along the normal; false if the line
/// passes the shape, or ends more than the margin behind the point.
bool TriangleCandidates::add_before(const Vec3& on_mesh, const Vec3& normal) {
  const Vec3 start =
      rounded_support(core_, normal) + normal * (core_.bounding_radius + core_.radius);
  const Vec3 origin = on_mesh + normal * dot(start - on_mesh, normal);
  const std::optional<narrowphase::CoreRayHit> hit = cast_ray(bare(), origin, -normal);
  if (!hit) return false;
  const double depth = dot(origin - normal * hit->distance - on_mesh, normal) + candidates_.margin;
  if (depth < 0) return false;
  candidates_.found.push_back({on_mesh + normal * depth, on_mesh, normal, depth,
                               narrowphase::kPointFeature, narrowphase::kPointFeature});
  return true;
}

/// Where the deepest point lies beyond what is touched, as in a valley: the point of the triangle
/// next to it, or to the shape's middle, or one that the two share, and where the shape ends behind
/// it along the way out. So the normal stays that of the way, whatever is deep.
void TriangleCandidates::add_beside(const TouchedTriangle& member) {
  const Parting parting = parting_of(member);
  const Vec3& out = parting.penetration.normal;
  const Vec3 deepest = rounded_support(core_, out);
  candidates_.found.clear();
  const narrowphase::CoreGap shared = narrowphase::nearest(core_, member.triangle);
  for (const Vec3& near : {deepest - out * parting.penetration.depth, core_.at, shared.point_b}) {
    if (!add_before(nearest_on_triangle(member.triangle, near), out)) continue;
    return take(face_feature(member.parting.triangle));
  }
  // The line through it leaves the shape beside it: the two graze each other there.
  if (candidates_.margin > 0) {
    const narrowphase::CoreGap gap = narrowphase::nearest(bare(), member.triangle);
    const Vec3 between = unit_or(gap.point_b - gap.point_a, out);
    add_apart(gap.point_a + between * bare().radius, gap.point_b, out);
  } else {
    candidates_.found.push_back({shared.point_b, shared.point_b, out, 0, narrowphase::kPointFeature,
                                 narrowphase::kPointFeature});
  }
  take(face_feature(member.parting.triangle));
}

/// How the shape parts soonest from a triangle alone.
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

/// Whether a point that is meant to be on the shape's surface is there.
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

/// Points over an edge that two triangles share are found with both: that of the first stays.
void TriangleCandidates::drop_doubles(std::size_t first) {
  std::vector<ContactPoint>& list = candidates_.list;
  if (list.size() - first > 64) return;  // reduce() leaves the farthest
  constexpr double kOnePoint = 1e-9;
  const double within = kOnePoint * (core_.bounding_radius + core_.radius);
  std::size_t kept = first;
  for (std::size_t i = first; i < list.size(); ++i) {
    const auto is_same = [&](const ContactPoint& other) {
      const bool is_one_feature = other.feature_a == narrowphase::kPointFeature &&
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

/// Edges and corners of faces that count are those faces' business.
bool TriangleCandidates::is_held(std::uint32_t vertex) const {
  return std::binary_search(s_.held.begin(), s_.held.end(), vertex);
}

}  // namespace graze
