#include <graze/engine/mesh/data/mesh_patch.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/local_parting.h>
#include <graze/engine/world/contacts/margin/near_triangles.h>
#include <graze/engine/world/shapes/mesh_descent.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>

namespace graze {

using narrowphase::ContactPoint;
using narrowphase::Core;
using narrowphase::CoreGap;
using narrowphase::Vec3;

namespace {

// Lengths below this share of the pair's scale count as 0.
constexpr double kNegligible = 1e-9;

// The cosine of 1.4e-5 radians: a direction that is that near to a face's normal is replaced by it,
// which changes lengths by at most a share of 1e-10.
constexpr double kAlongNormal = 1 - 1e-10;

// Rounding turns the line between points that are nearer to each other than this share of the
// pair's scale by more than kNegligible: where faces lie along each other the faces then tell the
// exit.
constexpr double kUntold = 1e-7;

// The cosine of 2 degrees, within which two ways out are one.
constexpr double kAlongExit = 0.9994;

// Points that are nearer to each other than this share of a region's size are one, such as a corner
// that is found on either side of an edge, or also as an end of a crossing.
constexpr double kOnePlace = 1e-4;

/// Returns the box around a mesh in its own frame, as a core.
Core box_of(const PlacedMeshView& mesh, const Vec3& origin) {
  const double* m = mesh.pose.data();  // column-major 4x4
  const Vec3 min = to_vec3(mesh.mesh.bounds().min), max = to_vec3(mesh.mesh.bounds().max);
  const Vec3 middle = (min + max) * 0.5;
  Core box;
  box.kind = narrowphase::CoreKind::Box;
  for (int k = 0; k < 3; ++k)
    box.axis[k] = {m[4 * k], m[4 * k + 1], m[4 * k + 2]};
  box.half = (max - min) * 0.5;
  box.bounding_radius = length(box.half);
  box.at = turned(box, middle) + Vec3{m[12], m[13], m[14]} - origin;
  return box;
}

bool has_point(const Core& triangle, const Vec3& point, double within) {
  Core at;
  at.at = point;
  return narrowphase::nearest(triangle, at).upper <= within;
}

/// True if nothing of the triangle is ahead of a point in a direction.
bool is_behind(const Core& triangle, const Vec3& point, const Vec3& direction, double within) {
  return std::all_of(triangle.corner, triangle.corner + 3,
                     [&](const Vec3& corner) { return dot(corner - point, direction) <= within; });
}

}  // namespace

NearTriangles::NearTriangles(const PlacedMeshView& a, const PlacedMeshView& b,
                             ContactCandidates& candidates, Work& work)
    : mesh_a_(a), mesh_b_(b), candidates_(candidates), work_(work), s_(scratch()) {
  s_.pairs.clear(), s_.exits.clear(), s_.local.clear(), s_.touches.clear();
}

NearTriangles::Scratch& NearTriangles::scratch() {
  static thread_local Scratch kept;  // no pair is looked at within another
  return kept;
}

void NearTriangles::add() {
  grow_known();
  find_near_pairs();
  find_exits();
  for (const NearPair& pair : s_.pairs)
    add_faces(pair);
  rebuild();
}

/// Grows the known regions, which are those of the meshes without margin. If the meshes touch along
/// several directions at once, each direction has its own regions.
void NearTriangles::grow_known() {
  candidates_.end_region();
  const double margin = candidates_.margin;
  std::size_t first = 0;
  for (const std::size_t end : candidates_.ends) {
    const std::uint32_t own = add_exit(candidates_.list[first].normal, 0);
    for (; first < end; ++first) {
      const ContactPoint& touch = candidates_.list[first];
      const bool is_along = dot(touch.normal, s_.exits[own].normal) > kAlongExit;
      const std::uint32_t region = is_along ? own : region_of(touch.normal);
      RegionExit& exit = s_.exits[region];
      const double depth = touch.depth + margin;
      exit.depth = std::max(exit.depth, depth);
      s_.touches.push_back({region, {touch.point_a + exit.normal * margin, touch.point_b, depth}});
    }
  }
}

void NearTriangles::find_near_pairs() {
  const Vec3 origin = to_vec3(candidates_.origin);
  Core around_b = box_of(mesh_b_, origin);
  around_b.radius = candidates_.margin;
  MeshDescent descent_a(mesh_a_, around_b, candidates_.origin, work_);
  descent_a.for_each_near([&](std::uint32_t index_a) {
    const Core of_a = descent_a.triangle(index_a);
    Core grown = of_a;
    grown.radius = candidates_.margin;
    MeshDescent descent_b(mesh_b_, grown, candidates_.origin, work_);
    descent_b.for_each_near([&](std::uint32_t index_b) {
      const Core of_b = descent_b.triangle(index_b);
      const CoreGap gap = narrowphase::nearest(of_a, of_b);
      ++work_.convex_tests;
      if (gap.upper > candidates_.margin) return bvh::Walk::Continue;
      s_.pairs.push_back({index_a, index_b, of_a, of_b, LocalPartings::normal_of(of_a),
                          LocalPartings::normal_of(of_b), gap.point_a, gap.point_b, gap.upper});
      return bvh::Walk::Continue;
    });
    return bvh::Walk::Continue;
  });
  std::sort(s_.pairs.begin(), s_.pairs.end(), [](const NearPair& s, const NearPair& t) {
    return s.index_a != t.index_a ? s.index_a < t.index_a : s.index_b < t.index_b;
  });
}

/// Finds the exits of features that are apart: those that face each other and are as near to each
/// other as anything around them.
void NearTriangles::find_exits() {
  const bool nothing_touches = s_.exits.empty();
  for (const NearPair& pair : s_.pairs) {
    const double scale = pair_scale(pair.of_a, pair.of_b);
    if (nothing_touches && pair.distance <= kUntold * scale &&
        -dot(pair.normal_a, pair.normal_b) > kAlongExit) {
      s_.local.push_back({-pair.normal_b, &pair});
      continue;
    }
    const double negligible = kNegligible * scale;
    if (pair.distance <= negligible) continue;  // those cross or touch
    const Vec3 normal = exit_direction(pair);
    if (is_local(pair, normal, negligible)) s_.local.push_back({normal, &pair});
  }
  std::stable_sort(s_.local.begin(), s_.local.end(), [](const LocalExit& s, const LocalExit& t) {
    return s.pair->distance < t.pair->distance;
  });
  const double margin = candidates_.margin;
  for (const LocalExit& local : s_.local) {
    const std::uint32_t region = region_of(local.normal);
    const Vec3& normal = s_.exits[region].normal;
    const Vec3 grown = local.pair->point_a + normal * margin;
    const double depth = std::max(dot(grown - local.pair->point_b, normal), 0.0);
    s_.touches.push_back({region, {grown, local.pair->point_b, depth}});
  }
}

/// Returns the direction of the line between the nearest points. A small distance magnifies their
/// rounding, so a direction that is along a face's normal is replaced by the normal.
Vec3 NearTriangles::exit_direction(const NearPair& pair) {
  const Vec3 between = (pair.point_b - pair.point_a) * (1 / pair.distance);
  if (-dot(pair.normal_b, between) > kAlongNormal) return -pair.normal_b;
  if (dot(pair.normal_a, between) > kAlongNormal) return pair.normal_a;
  return between;
}

/// True if the two features face each other along the normal and nothing around them is nearer. All
/// triangles around a nearest point are near, too.
bool NearTriangles::is_local(const NearPair& pair, const Vec3& normal, double negligible) const {
  double facing_a = -1, facing_b = -1;
  for (const NearPair& other : s_.pairs) {
    if (other.index_a == pair.index_a && has_point(other.of_b, pair.point_b, negligible)) {
      if (!is_behind(other.of_b, pair.point_b, -normal, negligible)) return false;
      facing_b = std::max(facing_b, -dot(other.normal_b, normal));
    }
    if (other.index_b == pair.index_b && has_point(other.of_a, pair.point_a, negligible)) {
      if (!is_behind(other.of_a, pair.point_a, normal, negligible)) return false;
      facing_a = std::max(facing_a, dot(other.normal_a, normal));
    }
  }
  return facing_a > 0 && facing_b > 0;
}

/// Returns the number of the first region that is left along a direction, or the number of regions
/// if there is none.
std::size_t NearTriangles::along(const Vec3& normal) const {
  const auto at = std::find_if(s_.exits.begin(), s_.exits.end(), [&](const RegionExit& exit) {
    return dot(exit.normal, normal) > kAlongExit;
  });
  return static_cast<std::size_t>(at - s_.exits.begin());
}

std::uint32_t NearTriangles::add_exit(const Vec3& normal, double depth) {
  s_.exits.push_back({normal, depth, along(normal) == s_.exits.size()});
  return static_cast<std::uint32_t>(s_.exits.size() - 1);
}

std::uint32_t NearTriangles::region_of(const Vec3& normal) {
  const std::size_t known = along(normal);
  return known < s_.exits.size() ? static_cast<std::uint32_t>(known)
                                 : add_exit(normal, candidates_.margin);
}

/// Adds contacts between two faces along each exit to which both are nearly at right angles.
void NearTriangles::add_faces(const NearPair& pair) {
  if (FacingFeatures::is_sliver(pair.of_a) || FacingFeatures::is_sliver(pair.of_b)) return;
  for (std::uint32_t region = 0; region < s_.exits.size(); ++region) {
    const RegionExit& exit = s_.exits[region];
    if (!exit.is_first_along || dot(pair.normal_a, exit.normal) < kNearlyFacing ||
        -dot(pair.normal_b, exit.normal) < kNearlyFacing)
      continue;
    narrowphase::Penetration penetration{};
    penetration.normal = exit.normal;
    penetration.depth = exit.depth - candidates_.margin;
    candidates_.found.clear();
    add_face_contact_points(pair.of_a, pair.of_b, penetration, candidates_.found,
                            candidates_.margin);
    for (const ContactPoint& touch : candidates_.found) {
      const double depth = std::max(dot(touch.point_a - touch.point_b, touch.normal), 0.0);
      if (depth <= exit.depth)
        s_.touches.push_back({region, {touch.point_a, touch.point_b, depth}});
    }
  }
}

/// Gathers the points of a region, the deepest of those in one place, and returns the size of the
/// region.
double NearTriangles::gather(std::uint32_t region) {
  s_.met.clear();
  double size = candidates_.margin;
  const Vec3* first = nullptr;
  for (const Touch& touch : s_.touches) {
    if (touch.region != region) continue;
    if (first == nullptr) first = &touch.met.b;
    size = std::max(size, largest(touch.met.b - *first));
  }
  for (const Touch& touch : s_.touches) {
    if (touch.region != region) continue;
    const auto known = std::find_if(s_.met.begin(), s_.met.end(), [&](const MetPoints& other) {
      return largest(other.b - touch.met.b) <= kOnePlace * size;
    });
    if (known == s_.met.end()) {
      s_.met.push_back(touch.met);
    } else if (touch.met.depth > known->depth + kSameMetDepth * size) {
      *known = touch.met;
    }
  }
  return size;
}

/// Writes all candidates anew, region by region.
void NearTriangles::rebuild() {
  candidates_.clear();
  for (std::uint32_t region = 0; region < s_.exits.size(); ++region) {
    const double size = gather(region);
    if (!s_.met.empty()) {
      add_ends(s_.met,
               {.pose_a = mesh_a_.pose,
                .pose_b = mesh_b_.pose,
                .exit = -s_.exits[region].normal,
                .size = size,
                .margin = candidates_.margin},
               candidates_.list);
    }
    candidates_.end_region();
  }
}

void add_near_triangles(const PlacedShapeView& a, const PlacedShapeView& b,
                        ContactCandidates& candidates, Work& work) {
  NearTriangles({*a.shape.as<Mesh>(), a.pose}, {*b.shape.as<Mesh>(), b.pose}, candidates, work)
      .add();
}

}  // namespace graze
