// Answers of a body of parts about another shape, without a world: for all of its parts together.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/body_shapes/moving_parts.h>
#include <graze/engine/world/body_shapes/part_pairs.h>

#include <algorithm>

namespace graze {
namespace {

/// The contacts of pairs of parts as one manifold.
class MergedManifold {
 public:
  void add(const Manifold& found) {
    for (std::size_t region = 0; region < found.region_count(); ++region) {
      const std::span<const ShapeContact> contacts = found.region(region);
      double deepest = contacts[0].depth;
      for (const ShapeContact& contact : contacts)
        deepest = std::max(deepest, contact.depth);
      regions_.push_back({deepest, {contacts.begin(), contacts.end()}});
    }
  }

  /// Returns the manifold. Equal features from pairs of different parts are told apart by their
  /// order.
  Manifold merged() {
    std::stable_sort(regions_.begin(), regions_.end(),
                     [](const Region& s, const Region& t) { return s.deepest > t.deepest; });
    Manifold all;
    std::uint32_t number = 0;
    for (const Region& region : regions_) {
      for (ShapeContact contact : region.contacts) {
        contact.region = number;
        while (has(all, contact.feature))
          contact.feature.b += std::uint64_t{1} << 28;
        all.add(contact);
      }
      ++number;
    }
    return all;
  }

 private:
  struct Region {
    double deepest;
    std::vector<ShapeContact> contacts;
  };

  static bool has(const Manifold& manifold, const ContactFeature& feature) {
    return std::any_of(manifold.begin(), manifold.end(),
                       [&](const ShapeContact& contact) { return contact.feature == feature; });
  }

  std::vector<Region> regions_;
};

Manifold contacts_of_all(const PosedBody& a, const PosedBody& b, const ManifoldSettings& settings) {
  MergedManifold all;
  Manifold found;
  for_part_pairs(a, b, [&](const PlacedPart& s, const PlacedPart& t) {
    contacts_of(s, t, settings, found);
    all.add(found);
    return true;
  });
  return all.merged();
}

/// True if s is to be preferred to t: the earlier contact, and of equal times a hit.
bool is_earlier(const RigidContact& s, const RigidContact& t) {
  if ((s.status == RigidStatus::Free) != (t.status == RigidStatus::Free))
    return t.status == RigidStatus::Free;
  if (s.low != t.low) return s.low < t.low;
  return s.status == RigidStatus::Hit && t.status != RigidStatus::Hit;
}

}  // namespace

bool PartsBody::touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bool do_touch = false;
    for_part_pairs({*this, pose}, {other, other_pose},
                   [&](const PlacedPart& s, const PlacedPart& t) {
                     do_touch = nearness_of(s, t, {}) == Nearness::Touching;
                     return !do_touch;
                   });
    return do_touch;
  });
}

Manifold PartsBody::contacts(const Pose& pose, const BodyShape& other,
                             const Pose& other_pose) const {
  return bvh::in_standard_arithmetic([&]() -> Manifold {
    return contacts_of_all({*this, pose}, {other, other_pose}, {});
  });
}

Manifold PartsBody::contacts_within(const Pose& pose, const BodyShape& other,
                                    const Pose& other_pose, double margin) const {
  return bvh::in_standard_arithmetic([&]() -> Manifold {
    check_margin(margin, "contacts_within");
    return contacts_of_all({*this, pose, margin}, {other, other_pose}, {.margin = margin});
  });
}

std::optional<RayHit> PartsBody::cast_ray(const Pose& pose, const Ray& ray) const {
  return bvh::in_standard_arithmetic([&]() -> std::optional<RayHit> {
    check_ray(ray, "cast_ray");
    const auto found = first_hit(pose, ray, {});
    if (!found) return std::nullopt;
    return found->hit;
  });
}

RigidContact PartsBody::first_contact(const RigidMotion& motion, const BodyShape& other,
                                      const RigidMotion& other_motion,
                                      const RigidContactSettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> RigidContact {
    RigidContact earliest{
        .status = RigidStatus::Free, .low = 1, .high = 1, .is_out_of_budget = false};
    for_moving_part_pairs({*this, motion}, {other, other_motion}, settings,
                          [&](const MovingPart& s, const MovingPart& t) {
                            const RigidContact found = first_contact_of(s, t, settings);
                            if (is_earlier(found, earliest)) earliest = found;
                          });
    return earliest;
  });
}

}  // namespace graze
