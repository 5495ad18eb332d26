#include <graze/engine/mesh/data/mesh_patch.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/contact_regions.h>
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

// Lengths below this share of the pair's scale are none.
constexpr double kNegligible = 1e-9;

// Cosine of the angle within which a direction is a face's normal, 1.4e-5: taken for it, it is as
// long to 1e-10.
constexpr double kAlongNormal = 1 - 1e-10;

/// The box around a mesh in its own frame, as a set.
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

/// Whether nothing of the triangle is ahead of a point in a direction.
bool is_behind(const Core& triangle, const Vec3& point, const Vec3& direction, double within) {
  return std::all_of(triangle.corner, triangle.corner + 3,
                     [&](const Vec3& corner) { return dot(corner - point, direction) <= within; });
}

}  // namespace

NearTriangles::NearTriangles(const PlacedMeshView& a, const PlacedMeshView& b,
                             ContactCandidates& candidates, Work& work)
    : mesh_a_(a), mesh_b_(b), candidates_(candidates), work_(work), s_(scratch()) {
  s_.pairs.clear(), s_.ways.clear(), s_.touches.clear();
}

NearTriangles::Scratch& NearTriangles::scratch() {
  static thread_local Scratch kept;  // no pair is looked at within another
  return kept;
}

void NearTriangles::add() {
  grow_known();
  find_pairs();
  find_ways();
  for (const NearPair& pair : s_.pairs)
    add_faces(pair);
  rebuild();
}

/// The regions that are known are those of the meshes themselves.
void NearTriangles::grow_known() {
  candidates_.end_region();
  const double margin = candidates_.margin;
  std::size_t first = 0;
  for (std::uint32_t region = 0; region < candidates_.ends.size(); ++region) {
    RegionWay way{candidates_.list[first].normal, 0};
    for (std::size_t i = first; i < candidates_.ends[region]; ++i) {
      ContactPoint touch = candidates_.list[i];
      touch.depth += margin;
      touch.point_a = touch.point_a + touch.normal * margin;
      way.depth = std::max(way.depth, touch.depth);
      s_.touches.push_back({region, touch});
    }
    s_.ways.push_back(way);
    first = candidates_.ends[region];
  }
}

void NearTriangles::find_pairs() {
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

/// The ways out of what is apart: where two features are as near to each other as anything around
/// them, and face each other.
void NearTriangles::find_ways() {
  for (const NearPair& pair : s_.pairs) {
    const double negligible = kNegligible * (pair_scale(pair.of_a, pair.of_b));
    if (pair.distance <= negligible) continue;  // those cross or touch
    const Vec3 normal = way_of(pair);
    if (!is_local(pair, normal, negligible)) continue;
    const std::uint32_t region = region_of(normal);
    s_.touches.push_back({region, point_of(pair, normal)});
  }
}

/// Along the line between the nearest points, whose rounding a small distance magnifies: where that
/// is along a face's normal it is the normal.
Vec3 NearTriangles::way_of(const NearPair& pair) const {
  const Vec3 between = (pair.point_b - pair.point_a) * (1 / pair.distance);
  if (-dot(pair.normal_b, between) > kAlongNormal) return -pair.normal_b;
  if (dot(pair.normal_a, between) > kAlongNormal) return pair.normal_a;
  return between;
}

/// All triangles around a nearest point are near, too.
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

std::uint32_t NearTriangles::region_of(const Vec3& normal) {
  const auto at = std::find_if(s_.ways.begin(), s_.ways.end(), [&](const RegionWay& way) {
    return is_one_direction(way.normal, normal);
  });
  if (at == s_.ways.end()) {
    s_.ways.push_back({normal, candidates_.margin});
    return static_cast<std::uint32_t>(s_.ways.size() - 1);
  }
  return static_cast<std::uint32_t>(at - s_.ways.begin());
}

ContactPoint NearTriangles::point_of(const NearPair& pair, const Vec3& normal) const {
  return {pair.point_a + normal * candidates_.margin,
          pair.point_b,
          normal,
          std::max(candidates_.margin - pair.distance, 0.0),
          std::uint64_t{numbers_of(mesh_a_.mesh).triangle(pair.index_a)} << 32 |
              narrowphase::kPointFeature,
          std::uint64_t{numbers_of(mesh_b_.mesh).triangle(pair.index_b)} << 32 |
              narrowphase::kPointFeature};
}

/// Where both faces are nearly at right angles to a way, what lies between them has contacts along
/// it.
void NearTriangles::add_faces(const NearPair& pair) {
  if (FacingFeatures::is_sliver(pair.of_a) || FacingFeatures::is_sliver(pair.of_b)) return;
  for (std::uint32_t region = 0; region < s_.ways.size(); ++region) {
    const RegionWay& way = s_.ways[region];
    if (dot(pair.normal_a, way.normal) < kNearlyFacing ||
        -dot(pair.normal_b, way.normal) < kNearlyFacing)
      continue;
    narrowphase::Penetration penetration{};
    penetration.normal = way.normal;
    penetration.depth = way.depth - candidates_.margin;
    candidates_.found.clear();
    add_face_contact_points(pair.of_a, pair.of_b, penetration, candidates_.found,
                            candidates_.margin);
    for (ContactPoint& touch : candidates_.found) {
      touch.depth = std::max(dot(touch.point_a - touch.point_b, touch.normal), 0.0);
      if (touch.depth > way.depth) continue;
      touch.feature_a = std::uint64_t{numbers_of(mesh_a_.mesh).triangle(pair.index_a)} << 32 |
                        (touch.feature_a & 0xffffffff);
      touch.feature_b = std::uint64_t{numbers_of(mesh_b_.mesh).triangle(pair.index_b)} << 32 |
                        (touch.feature_b & 0xffffffff);
      s_.touches.push_back({region, touch});
    }
  }
}

/// Writes all candidates anew, region by region, each point once: the first that was found.
void NearTriangles::rebuild() {
  candidates_.clear();
  std::vector<ContactPoint>& list = candidates_.list;
  for (std::uint32_t region = 0; region < s_.ways.size(); ++region) {
    const std::size_t first = list.size();
    for (const Touch& touch : s_.touches) {
      if (touch.region != region) continue;
      const double within = kNegligible * (largest(touch.point.point_a) + candidates_.margin);
      const auto is_same = [&](const ContactPoint& other) {
        return largest(other.point_b - touch.point.point_b) <= within;
      };
      if (std::any_of(list.begin() + static_cast<std::ptrdiff_t>(first), list.end(), is_same))
        continue;
      list.push_back(touch.point);
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
