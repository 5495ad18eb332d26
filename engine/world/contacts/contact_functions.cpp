#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/contact/reduction.h>
#include <graze/narrowphase/convex/core/contact_face.h>
#include <graze/narrowphase/convex/depth/box_axes.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace graze {

using narrowphase::ContactFace;
using narrowphase::Core;
using narrowphase::CoreGap;
using narrowphase::Parting;
using narrowphase::Vec3;

// Intersection has been tested before: all pairs here touch, or are as near as the margin, except
// boxes without a margin.

namespace {

/// Finds the candidates of two spheres: their formulas are so short that cores would cost more.
bool candidates_of_spheres(const PlacedShapeView& a, const PlacedShapeView& b,
                           ContactCandidates& candidates) {
  const Sphere& sphere_a = *a.shape.as<Sphere>();
  const Sphere& sphere_b = *b.shape.as<Sphere>();
  candidates.origin = middle_of(a.shape, a.pose);
  const Vec3 between = to_vec3(middle_of(b.shape, b.pose)) - to_vec3(candidates.origin);
  const double distance = length(between);
  const double radius_a = sphere_a.radius + candidates.margin;
  const double radii = radius_a + sphere_b.radius;
  if (!(distance > 0x1p-20 * radii)) return false;
  const Vec3 normal = unit_or(between, {0, 0, 1});
  const Vec3 on_a = normal * radius_a;
  const Vec3 on_b = between - normal * sphere_b.radius;
  candidates.list.push_back({on_a, on_b, normal, std::max(radii - distance, 0.0),
                             narrowphase::kPointFeature, narrowphase::kPointFeature});
  return true;
}

}  // namespace

void sign_depth(const Core& core_a, const Core& core_b, Parting& parting) {
  narrowphase::Penetration& penetration = parting.penetration;
  if (!(penetration.depth > 0)) penetration.depth = along(core_a, core_b, penetration.normal).depth;
}

void reduce_from(std::size_t first, const narrowphase::ContactSurfaces& surfaces,
                 ContactCandidates& candidates) {
  const auto begin = candidates.list.begin() + static_cast<std::ptrdiff_t>(first);
  const auto is_extra = [](const narrowphase::ContactPoint& contact) {
    return contact.feature_a == narrowphase::kDeepestOfFace;
  };
  if (candidates.list.size() - first <= Manifold::kMostOfRegion &&
      std::none_of(begin, candidates.list.end(), is_extra))
    return;
  const std::size_t kept = narrowphase::reduce(
      std::span(candidates.list).subspan(first),
      {.most = Manifold::kMostOfRegion, .margin = candidates.margin, .surfaces = &surfaces});
  candidates.list.resize(first + kept);
}

void candidates_of_cores(const PlacedShapeView& a, const PlacedShapeView& b,
                         ContactCandidates& candidates, Work& work) {
  if (b.shape.kind() == ShapeKind::Sphere && candidates_of_spheres(a, b, candidates)) return;
  candidates.origin = middle_of(a.shape, a.pose);
  const Core core_a = core_of(a.shape, a.pose, candidates.origin);
  const Core core_b = core_of(b.shape, b.pose, candidates.origin);
  const CoreGap gap = narrowphase::nearest(core_a, core_b);
  ++work.convex_tests;
  Parting parting = part(core_a, core_b, gap);
  work.penetration_tests += parting.is_asked;
  work.penetration_failures += parting.is_failed;
  if (candidates.margin > 0) sign_depth(core_a, core_b, parting);
  add_contact_points(core_a, core_b, parting, candidates.list, candidates.margin);
  reduce_from(0, narrowphase::CoreSurfaces(core_a, core_b, candidates.margin), candidates);
}

// The axes along which boxes part mostly tell for sure whether they touch.
void candidates_of_boxes(const PlacedShapeView& a, const PlacedShapeView& b,
                         ContactCandidates& candidates, Work& work) {
  using narrowphase::Verdict;
  if (candidates.margin > 0) return candidates_of_cores(a, b, candidates, work);
  candidates.origin = middle_of(a.shape, a.pose);
  const Core core_a = core_of(a.shape, a.pose, candidates.origin);
  const Core core_b = core_of(b.shape, b.pose, candidates.origin);
  const narrowphase::BoxAxes axes(core_a, core_b);
  const Verdict verdict = axes.verdict();
  if (verdict == Verdict::No) return;
  if (verdict == Verdict::Unsure && !intersect_in_boxes(a, b, work)) return;
  add_contact_points(core_a, core_b, part_boxes(axes), candidates.list);
  reduce_from(0, narrowphase::CoreSurfaces(core_a, core_b, candidates.margin), candidates);
}

/// The surfaces of a convex set with a face over a plane, and of the plane.
class OverPlane final : public narrowphase::ContactSurfaces {
 public:
  OverPlane(const Core& core, double margin) : core_(core), margin_(margin) {}
  bool hold(narrowphase::ContactPoint& contact) const override {
    if (!move_onto_face(core_, contact.normal, margin_, contact.point_a)) return false;
    contact.depth = std::max(dot(contact.point_a - contact.point_b, contact.normal), contact.depth);
    return true;
  }

 private:
  const Core& core_;
  double margin_;
};

void candidates_with_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                           ContactCandidates& candidates) {
  candidates.origin = middle_of(a.shape, a.pose);
  const Core core = core_of(a.shape, a.pose, candidates.origin);
  const double margin = candidates.margin;
  const PlacedHalfSpace plane =
      placed_half_space(*b.shape.as<HalfSpace>(), b.pose, candidates.origin);
  const Vec3 down = -plane.normal;
  const auto add = [&](const Vec3& point, std::uint64_t feature) {
    const double depth = plane.offset - dot(plane.normal, point);
    const Vec3 foot = point + plane.normal * depth;
    candidates.list.push_back({point, foot, down, std::max(depth, 0.0), feature, 0});
    if (!(margin > 0)) return;
    candidates.list.back().point_a = point + down * margin;
    candidates.list.back().depth = std::max(depth + margin, 0.0);
  };
  const Vec3 lowest = rounded_support(core, down);
  const double deepest = plane.offset - dot(plane.normal, lowest);
  const ContactFace face = face_along(core, down);
  const double tolerance =
      kTouchTolerance * (core.bounding_radius + core.radius + margin + std::abs(plane.offset));
  double found = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < face.count; ++i) {
    const double depth = plane.offset - dot(plane.normal, face.corner[i]);
    if (depth + margin < -tolerance) continue;
    found = std::max(found, depth);
    add(face.corner[i], (static_cast<std::uint64_t>(face.id) << 32) | face.corner_id[i]);
  }
  // The corners of a face, above all of a round one, may leave out the deepest point itself.
  const double size = core.bounding_radius + core.radius;
  const double least = narrowphase::least_offered(deepest + margin, {margin, size}) - tolerance;
  if (found + margin < 0 || found + margin < least) {
    const bool is_beside = found + margin >= 0 && face.count > 2;
    add(lowest, is_beside ? narrowphase::kDeepestOfFace : narrowphase::kPointFeature);
  }
  reduce_from(0, OverPlane(core, margin), candidates);
}

}  // namespace graze
