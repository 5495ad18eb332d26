#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/scaled_meshes.h>
#include <graze/engine/world/shapes/mesh_descent.h>
#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/core/contact_face.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace graze {

using narrowphase::ContactPoint;
using narrowphase::Core;
using narrowphase::Parting;
using narrowphase::Vec3;

namespace {

/// The contact candidates that triangles of a mesh offer beside a convex shape.
class TriangleCandidates {
 public:
  TriangleCandidates(const Core& core, ContactCandidates& candidates, Work& work)
      : core_(core), candidates_(candidates), work_(work) {}

  void add(std::uint32_t index, const Core& triangle) {
    PairStatus status{};
    ++work_.convex_tests;
    if (are_apart(core_, triangle, status)) return;
    offer(index, triangle);
  }

  /// Keeps the candidates of triangles that face the shape, or where there are none those of
  /// triangles that face away from it.
  void choose_side() {
    if (candidates_.list.empty()) std::swap(candidates_.list, candidates_.from_behind);
  }

  void offer(std::uint32_t index, const Core& triangle) {
    const Vec3 outward =
        cross(triangle.corner[1] - triangle.corner[0], triangle.corner[2] - triangle.corner[0]);
    const bool has_area = largest(outward) > 0;
    const Vec3 normal = unit_or(outward, {0, 0, 1});
    const bool is_front = has_area && dot(normal, core_.at - triangle.corner[0]) >= 0;
    std::vector<ContactPoint>& found = candidates_.found;
    found.clear();
    if (is_front) {
      Parting parting;
      parting.penetration = along(core_, triangle, -normal);
      parting.penetration.depth = std::max(parting.penetration.depth, 0.0);
      add_candidates_within(triangle, parting, found);
    }
    if (found.empty()) {
      const Parting parting = least_parting(triangle, has_area);
      work_.penetration_tests += parting.is_asked;
      work_.penetration_failures += parting.is_failed;
      add_contact_points(core_, triangle, parting, found);
    }
    std::vector<ContactPoint>& list =
        is_front || !has_area ? candidates_.list : candidates_.from_behind;
    for (ContactPoint& touch : found) {
      touch.feature_b = (static_cast<std::uint64_t>(index) << 32) | (touch.feature_b & 0xffffffff);
      list.push_back(touch);
    }
  }

 private:
  Parting least_parting(const Core& triangle, bool has_area) const {
    using enum narrowphase::CoreKind;
    if (has_area && (core_.kind == Box || core_.kind == Point))
      return part_from_triangle(core_, triangle);
    return part(core_, triangle, narrowphase::nearest(core_, triangle));
  }

  /// Contacts along the triangle's normal, if the shape's deepest point or some of its face is
  /// above the triangle itself.
  void add_candidates_within(const Core& triangle, const Parting& parting,
                             std::vector<ContactPoint>& found) {
    const Vec3& deepest = parting.penetration.point_a;
    const Vec3 normal = -parting.penetration.normal;
    bool is_within = true;
    for (int i = 0; i < 3; ++i) {
      const Vec3 edge = triangle.corner[(i + 1) % 3] - triangle.corner[i];
      is_within &= dot(cross(normal, edge), deepest - triangle.corner[i]) >= 0;
    }
    const narrowphase::ContactFace face = face_along(core_, parting.penetration.normal);
    if (face.count < 2) {
      if (is_within) add_point(deepest, parting, found);
      return;
    }
    add_face_contact_points(core_, triangle, parting.penetration, found);
    if (is_within) {
      double most = -1;
      for (const ContactPoint& touch : found)
        most = std::max(most, touch.depth);
      constexpr double kSameDepth = 1e-6;
      const double allowance = kSameDepth * (core_.bounding_radius + core_.radius);
      if (parting.penetration.depth - most > allowance) add_point(deepest, parting, found);
    }
  }

  void add_point(const Vec3& deepest, const Parting& parting, std::vector<ContactPoint>& found) {
    const Vec3 on_triangle = deepest - parting.penetration.normal * parting.penetration.depth;
    found.push_back({deepest, on_triangle, parting.penetration.normal, parting.penetration.depth,
                     narrowphase::kPointFeature, narrowphase::kPointFeature});
  }

  const Core& core_;
  ContactCandidates& candidates_;
  Work& work_;
};

/// The lowest triangle of the mesh that comes as near to the point as rounding has moved it.
std::uint32_t triangle_at(const PlacedMeshView& mesh, const Eigen::Vector3d& point) {
  const double size = largest(to_vec3(mesh.mesh.bounds().max) - to_vec3(mesh.mesh.bounds().min)) +
                      largest(to_vec3(point));
  const double least = std::numeric_limits<double>::denorm_min();  // 0 would never grow
  for (double radius = std::max(0x1p-48 * size, least); radius < size; radius *= 16) {
    const TriangleList found = find_triangles(mesh, Sphere{point, radius});
    if (!found.empty()) return found.triangles.front();
  }
  return 0;
}

}  // namespace

void candidates_of_mesh_core(const PlacedShapeView& a, const PlacedShapeView& b,
                             ContactCandidates& candidates, Work& work) {
  const PlacedMeshView mesh{*b.shape.as<Mesh>(), b.pose};
  candidates.origin = middle_of(a.shape, a.pose);
  const Core core = core_of(a.shape, a.pose, candidates.origin);
  MeshDescent descent(mesh, core, candidates.origin, work);
  TriangleCandidates found(core, candidates, work);
  descent.for_each_near([&](std::uint32_t index) {
    found.add(index, descent.triangle(index));
    return bvh::Walk::Continue;
  });
  found.choose_side();
  if (!candidates.list.empty()) return;
  // An exact hit that rounding keeps apart: the nearest triangle touches.
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  descent.for_each_within([&] { return least; },
                          [&](std::uint32_t index) {
                            const SetGap gap = gap_of_sets(core, descent.triangle(index), least);
                            if (gap.distance < least) least = gap.distance, nearest = index;
                            return bvh::Walk::Continue;
                          });
  found.offer(nearest, descent.triangle(nearest));
  found.choose_side();
}

namespace {

/// Whether a placed triangle and a box or a sphere share a point, exactly: as intersects() of a
/// mesh and one of these decides.
class ExactVolume {
 public:
  explicit ExactVolume(const PlacedShapeView& s) : pose_(s.pose) {
    if (const auto* box = s.shape.as<Box>()) {
      box_ = Aabb{-box->half_extents, box->half_extents};
    } else {
      const auto& sphere = *s.shape.as<Sphere>();
      ball_ = Sphere{narrowphase::place(s.pose, sphere.centre), sphere.radius};
    }
  }

  bool meets(const Triangle& placed, Work& work) const {
    ++work.triangle_tests;
    const narrowphase::Decision decision =
        box_ ? narrowphase::decide(narrowphase::into_frame(placed, pose_), *box_)
             : narrowphase::decide(placed, *ball_);
    work.exact_tests += decision.stage == narrowphase::Stage::Exact;
    return decision.is_hit;
  }

 private:
  const Pose& pose_;
  std::optional<Aabb> box_;
  std::optional<Sphere> ball_;
};

}  // namespace

void candidates_of_mesh_volume(const PlacedShapeView& a, const PlacedShapeView& b,
                               ContactCandidates& candidates, Work& work) {
  const PlacedMeshView mesh{*b.shape.as<Mesh>(), b.pose};
  candidates.origin = middle_of(a.shape, a.pose);
  const Core core = core_of(a.shape, a.pose, candidates.origin);
  const ExactVolume volume(a);
  MeshDescent descent(mesh, core, candidates.origin, work);
  TriangleCandidates found(core, candidates, work);
  descent.for_each_near([&](std::uint32_t index) {
    const Triangle placed = narrowphase::place(mesh.pose, mesh.mesh.triangle(index));
    if (volume.meets(placed, work)) found.offer(index, core_of(placed, candidates.origin));
    return bvh::Walk::Continue;
  });
  found.choose_side();
}

void candidates_of_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                              ContactCandidates& candidates, Work& work) {
  const Mesh& mesh = *b.shape.as<Mesh>();
  const double* m = b.pose.data();
  candidates.origin = Eigen::Vector3d(m[12], m[13], m[14]);
  const PlacedHalfSpace plane =
      placed_half_space(*a.shape.as<HalfSpace>(), a.pose, candidates.origin);
  const Aabb& box = mesh.bounds();
  const double size =
      largest(to_vec3(box.min)) + largest(to_vec3(box.max)) + std::abs(plane.offset) + plane.slack;
  std::vector<bool>& is_seen = candidates.is_seen;
  is_seen.assign(mesh.vertices().size(), false);
  double lowest = std::numeric_limits<double>::infinity();
  ContactPoint deepest{};
  for (const TriangleIndices& triangle : mesh.triangles()) {
    for (const std::uint32_t index : triangle) {
      if (is_seen[index]) continue;
      is_seen[index] = true;
      const Vec3 point =
          to_vec3(narrowphase::place(b.pose, mesh.vertices()[index])) - to_vec3(candidates.origin);
      const double height = dot(plane.normal, point) - plane.offset;
      const double depth = std::max(-height, 0.0);
      const Vec3 foot = point - plane.normal * height;
      const ContactPoint touch{foot, point, plane.normal, depth, 0, index};
      if (height < lowest) lowest = height, deepest = touch;
      if (height <= kTouchTolerance * size) candidates.list.push_back(touch);
    }
  }
  if (candidates.list.empty()) candidates.list.push_back(deepest);
  ++work.convex_tests;
}

namespace {

/// Of meshes that touch in planes, along lines or in points: by their exact intersection.
void candidates_of_pieces(const PlacedShapeView& a, const PlacedShapeView& b,
                          ContactCandidates& candidates, Work& work) {
  const PlacedMeshView mesh_a{*a.shape.as<Mesh>(), a.pose};
  const PlacedMeshView mesh_b{*b.shape.as<Mesh>(), b.pose};
  candidates.origin = middle_of(a.shape, a.pose);
  const Vec3 origin = to_vec3(candidates.origin);
  const MeshContacts contacts = find_contacts(mesh_a, mesh_b, {}, &work);
  for (const MeshContact& contact : contacts) {
    std::vector<ContactPoint>& of_piece = candidates.found;
    of_piece.clear();
    for (const Eigen::Vector3d& point : contacts.points_of(contact)) {
      const Vec3 on_both = to_vec3(point) - origin;
      of_piece.push_back({on_both, on_both, to_vec3(contact.normal), contact.depth, 0, 0});
    }
    narrowphase::reduce(of_piece, 4);
    candidates.list.insert(candidates.list.end(), of_piece.begin(), of_piece.end());
  }
  narrowphase::reduce(candidates.list, 4);
  for (ContactPoint& touch : candidates.list) {
    const Eigen::Vector3d point = to_eigen(touch.point_a + origin);
    touch.feature_a = static_cast<std::uint64_t>(triangle_at(mesh_a, point)) << 32;
    touch.feature_b = static_cast<std::uint64_t>(triangle_at(mesh_b, point)) << 32;
  }
}

}  // namespace

void candidates_of_meshes(const PlacedShapeView& a, const PlacedShapeView& b,
                          ContactCandidates& candidates, Work& work) {
  if (candidates_of_scaled_meshes(a, b, candidates, work)) return;
  if (!candidates_of_crossings(a, b, candidates, work))
    candidates_of_pieces(a, b, candidates, work);
}

}  // namespace graze
