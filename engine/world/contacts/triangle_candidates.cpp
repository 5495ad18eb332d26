#include <graze/engine/world/contacts/triangle_candidates.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/contact/reduction.h>
#include <graze/narrowphase/convex/core/contact_face.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <cmath>

namespace graze {

using narrowphase::ContactPoint;
using narrowphase::Core;
using narrowphase::Parting;
using narrowphase::Vec3;

namespace {

// A shape lies on a triangle with a face that leans from it by less than a hundredth.
constexpr double kLying = 1 - 5e-5;

void sort_by_number(std::span<TouchedTriangle> triangles) {
  std::sort(triangles.begin(), triangles.end(),
            [](const TouchedTriangle& s, const TouchedTriangle& t) {
              return s.parting.triangle < t.parting.triangle;
            });
}

/// The surfaces of a shape and of the triangles of a region.
class RegionSurfaces final : public narrowphase::ContactSurfaces {
 public:
  struct Settings {
    double margin;  ///< metres, by which the shape is grown
    double within;  ///< metres, within which a point counts as on a triangle
  };
  RegionSurfaces(const Core& core, std::span<const TouchedTriangle> members,
                 const Settings& settings)
      : core_(core), members_(members), settings_(settings) {}

  bool hold(ContactPoint& contact) const override {
    const auto has_it = [&](const TouchedTriangle& member) {
      return has(member.triangle, contact.point_b);
    };
    if (!std::any_of(members_.begin(), members_.end(), has_it)) return false;
    if (!move_onto_face(core_, contact.normal, settings_.margin, contact.point_a)) return false;
    contact.depth = std::max(dot(contact.point_a - contact.point_b, contact.normal), contact.depth);
    return true;
  }

 private:
  bool has(const Core& triangle, const Vec3& point) const {
    const Vec3 normal = LocalPartings::normal_of(triangle);
    if (!(std::abs(dot(normal, point - triangle.corner[0])) <= settings_.within)) return false;
    for (int k = 0; k < 3; ++k) {
      const Vec3 along = triangle.corner[(k + 1) % 3] - triangle.corner[k];
      const Vec3 inward = unit_or(cross(normal, along), normal);
      if (dot(inward, point - triangle.corner[k]) < -settings_.within) return false;
    }
    return true;
  }

  const Core& core_;
  std::span<const TouchedTriangle> members_;
  Settings settings_;
};

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
      lying_(core, features_, {.face_share = kFaceShare, .margin = candidates.margin}),
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

/// Returns the parting without the margin; its depth may be negative.
Parting TriangleCandidates::bare(Parting parting) const {
  parting.penetration.depth -= candidates_.margin;
  return parting;
}

/// True if the shape itself is wholly behind the triangle's plane: it does not touch the triangle,
/// and a shape that is near from behind is not led through it.
bool TriangleCandidates::is_behind(const Core& triangle) const {
  if (FacingFeatures::is_sliver(triangle)) return false;
  const Vec3 normal = LocalPartings::normal_of(triangle);
  return dot(rounded_support(bare(), normal) - triangle.corner[0], normal) < 0;
}

/// Adds a triangle that the shape touches.
void TriangleCandidates::offer(std::uint32_t index, const Core& triangle) {
  if (FacingFeatures::is_sliver(triangle)) {
    s_.slivers.push_back({{index, {}, LeftFeature::Face, 0}, triangle, 0, 0, 0});
    return;
  }
  const bool is_lying = lies_on(LocalPartings::normal_of(triangle));
  const LocalParting parting = (is_lying ? lying_ : partings_).of(index, triangle);
  double rank = parting.exit.depth;
  if (is_lying && parting.feature == LeftFeature::Face)
    rank = std::min(candidates_.margin + kFaceShare * (rank - candidates_.margin), rank);
  s_.touched.push_back({parting, triangle, rank, 0, 0});
}

void TriangleCandidates::offer(const LocalParting& parting, const Core& triangle) {
  s_.touched.push_back({parting, triangle, parting.exit.depth, 0, 0});
}

/// True if the shape has a polygon that faces a triangle of that normal. The last answer is kept,
/// because successive triangles mostly have one normal.
bool TriangleCandidates::lies_on(const Vec3& normal) {
  if (normal.x != asked_normal_.x || normal.y != asked_normal_.y || normal.z != asked_normal_.z) {
    const narrowphase::ContactFace face = face_along(core_, -normal);
    is_lying_ = face.count > 2 && -dot(face.normal, normal) >= kLying;
    asked_normal_ = normal;
  }
  return is_lying_;
}

void TriangleCandidates::finish() {
  // The order must not depend on the tree.
  sort_by_number(s_.touched);
  sort_by_number(s_.slivers);
  // If only slivers are touched, there is nothing that their normals could contradict.
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

/// Adds the point that parts a shape from the triangles of a region: one of those that the two are
/// nearest in, or the last that they touch in on the way out, whichever is deeper.
void TriangleCandidates::add_parting(const RegionMembers& region, double deepest,
                                     std::uint64_t of_shape) {
  const std::size_t before = candidates_.list.size();
  add_nearest(region.speaker);
  const bool has_nearest = candidates_.list.size() > before;
  if (has_nearest) deepest = std::max(deepest, candidates_.list.back().depth);
  if (!add_last_touch(region, deepest, of_shape) || !has_nearest) return;
  candidates_.list.erase(candidates_.list.begin() + static_cast<std::ptrdiff_t>(before));
}

void TriangleCandidates::add_region(std::span<TouchedTriangle> members) {
  s_.held.clear();
  for (const TouchedTriangle& member : members) {
    if (member.parting.feature != LeftFeature::Face) continue;
    for (int k = 0; k < 3; ++k)
      s_.held.push_back(features_.vertex(member.parting.triangle, k));
  }
  std::sort(s_.held.begin(), s_.held.end());
  const std::size_t before = candidates_.list.size();
  const TouchedTriangle speaker = speaker_of(members);
  // The exits of triangles of one plane are equally long but for rounding, which changes with each
  // step. So the order is by number: of points that two triangles share that of the lower number
  // stays.
  sort_by_number(members);
  if (s_.held.empty()) add_near_faces(speaker);
  for (const TouchedTriangle& member : members)
    add_member(member);
  double most = -1;
  for (std::size_t i = before; i < candidates_.list.size(); ++i)
    most = std::max(most, candidates_.list[i].depth);
  const double allowance = kOnSurface * (core_.bounding_radius + core_.radius);
  const double least =
      narrowphase::least_offered(speaker.parting.exit.depth,
                                 {candidates_.margin, core_.bounding_radius + core_.radius}) -
      allowance;
  const bool is_of_face = most >= 0 && face_along(core_, -speaker.parting.exit.direction).count > 2;
  const std::uint64_t part_of_deepest =
      is_of_face ? narrowphase::kDeepestOfFace : narrowphase::kPointFeature;
  // The corners of a face, above all of a round one, may leave out the deepest point itself. Over a
  // flat face that has hollows the walk to it from one triangle may end where that from another
  // does not.
  const auto add_deepest_of_any = [&] {
    if (add_deepest(speaker, part_of_deepest)) return true;
    return std::any_of(members.begin(), members.end(), [&](const TouchedTriangle& member) {
      return add_deepest(member, part_of_deepest);
    });
  };
  if (most < least && !add_deepest_of_any())
    add_parting({speaker, members, before}, most, part_of_deepest);
  if (candidates_.list.size() == before) add_grazing(speaker);
  drop_doubles(before);
  const RegionSurfaces surfaces(bare(), members,
                                {.margin = candidates_.margin, .within = allowance});
  reduce_from(before, surfaces, candidates_);
  candidates_.end_region();
}

}  // namespace graze
