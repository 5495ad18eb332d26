#include <graze/engine/mesh/data/mesh_patch.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/triangle_candidates.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shapes/mesh_descent.h>
#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace graze {

using narrowphase::ContactPoint;
using narrowphase::Core;
using narrowphase::Vec3;

namespace {

/// Returns the triangle of the lowest number that is as near to the point as rounding may have
/// moved it.
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
  Core core = core_of(a.shape, a.pose, candidates.origin);
  core.radius += candidates.margin;
  MeshDescent descent(mesh, core, candidates.origin, work);
  TriangleCandidates found(core, mesh, candidates, work);
  descent.for_each_near([&](std::uint32_t index) {
    found.add(index, descent.triangle(index));
    return bvh::Walk::Continue;
  });
  if (found.has_touched()) return found.finish();
  if (candidates.margin > 0) return;  // all that is near is behind its surface
  // This is an exact hit whose parts are apart by rounding: the nearest triangle counts as touched.
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  descent.for_each_within([&] { return least; },
                          [&](std::uint32_t index) {
                            const SetGap gap = gap_of_sets(core, descent.triangle(index), least);
                            if (gap.distance < least) least = gap.distance, nearest = index;
                            return bvh::Walk::Continue;
                          });
  found.offer(nearest, descent.triangle(nearest));
  found.finish();
}

namespace {

/// Decides exactly whether a placed triangle and a box or a sphere share a point, as intersects()
/// of a mesh and one of these does.
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
  if (candidates.margin > 0) return candidates_of_mesh_core(a, b, candidates, work);
  const PlacedMeshView mesh{*b.shape.as<Mesh>(), b.pose};
  candidates.origin = middle_of(a.shape, a.pose);
  const Core core = core_of(a.shape, a.pose, candidates.origin);
  const ExactVolume volume(a);
  // The test reads a box by law 3, as the tree does not: where its pose deviates from a rotation by
  // d the two differ by less than 8 d of its size.
  Core wide = core;
  wide.radius += 8 * rotation_deviation(a.pose) * core.bounding_radius;
  MeshDescent descent(mesh, wide, candidates.origin, work);
  TriangleCandidates found(core, mesh, candidates, work);
  descent.for_each_near([&](std::uint32_t index) {
    const Triangle placed = narrowphase::place(mesh.pose, mesh.mesh.triangle(index));
    if (volume.meets(placed, work)) found.offer(index, core_of(placed, candidates.origin));
    return bvh::Walk::Continue;
  });
  if (found.has_touched()) found.finish();
}

void candidates_of_mesh_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                              ContactCandidates& candidates, Work& work) {
  const Mesh& mesh = *b.shape.as<Mesh>();
  const double* m = b.pose.data();
  candidates.origin = Eigen::Vector3d(m[12], m[13], m[14]);
  PlacedHalfSpace plane = placed_half_space(*a.shape.as<HalfSpace>(), a.pose, candidates.origin);
  plane.offset += candidates.margin;
  const Aabb& box = mesh.bounds();
  const double size =
      largest(to_vec3(box.min)) + largest(to_vec3(box.max)) + std::abs(plane.offset) + plane.slack;
  std::vector<bool>& is_seen = candidates.is_seen;
  is_seen.assign(mesh.vertices().size(), false);
  const MeshNumbers numbers = numbers_of(mesh);
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
      const ContactPoint touch{foot, point, plane.normal, depth, 0, numbers.vertex(index)};
      if (height < lowest) lowest = height, deepest = touch;
      if (height <= kTouchTolerance * size) candidates.list.push_back(touch);
    }
  }
  if (candidates.list.empty()) candidates.list.push_back(deepest);
  ++work.convex_tests;
}

namespace {

/// Finds the candidates of meshes that touch in planes, along lines or in points, by their exact
/// intersection.
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
    of_piece.resize(narrowphase::reduce(of_piece, {.most = Manifold::kMostOfRegion}));
    candidates.list.insert(candidates.list.end(), of_piece.begin(), of_piece.end());
  }
  candidates.list.resize(narrowphase::reduce(candidates.list, {.most = Manifold::kMostOfRegion}));
  const MeshNumbers of_a = numbers_of(mesh_a.mesh), of_b = numbers_of(mesh_b.mesh);
  for (ContactPoint& touch : candidates.list) {
    const Eigen::Vector3d point = to_eigen(touch.point_a + origin);
    touch.feature_a = std::uint64_t{of_a.triangle(triangle_at(mesh_a, point))} << 32;
    touch.feature_b = std::uint64_t{of_b.triangle(triangle_at(mesh_b, point))} << 32;
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
