#pragma once

// A compound as a world asks it. Private to engine/world.

#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/compound.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace graze {

/// A part in the world, or a shape that is no compound and counts as its own part 0.
struct PlacedPart {
  const BodyShape* shape;
  Pose pose;
  Aabb box;              ///< as the broad phase would have it, but without room
  const Filter* filter;  ///< of its own, or nullptr
  std::uint32_t number;
};

/// Where a ray meets a part.
struct PartRayHit {
  RayHit hit;
  std::uint32_t part = 0;
};

/// Immutable. Parts are looked up in the compound's own frame by their boxes there, so that a pose
/// costs nothing for each of them; those that are found are placed, and then stand as bodies do.
class CompoundBody final : public BodyShape {
 public:
  /// Throws as share() does.
  explicit CompoundBody(const Compound& compound);

  const Compound& compound() const { return compound_; }
  /// Those whose boxes, with room around them, metres, share a point with a box in the world, but
  /// for such that are surely farther from all that is in it; ascending.
  std::vector<PlacedPart> near(const Pose& pose, const Aabb& box, double room) const;
  /// Where a ray meets first a part whose filter, if it has one, and the given one, if there is
  /// one, let it meet; of equal distances the least number.
  std::optional<PartRayHit> first_hit(const Pose& pose, const Ray& ray,
                                      const std::optional<Filter>& filter) const;

  bool allows_concurrent_calls() const override { return true; }
  Aabb bounds(const Pose& pose) const override;
  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override;
  Manifold contacts(const Pose& pose, const BodyShape& other,
                    const Pose& other_pose) const override;
  Manifold contacts_within(const Pose& pose, const BodyShape& other, const Pose& other_pose,
                           double margin) const override;
  std::optional<RayHit> cast_ray(const Pose& pose, const Ray& ray) const override;
  RigidContact first_contact(const RigidMotion& motion, const BodyShape& other,
                             const RigidMotion& other_motion,
                             const RigidContactSettings& settings) const override;
  double bounding_radius() const override { return radius_; }

 private:
  struct Slot {
    std::shared_ptr<const BodyShape> shape;
    std::uint32_t number;
  };

  PlacedPart placed(const Pose& pose, std::uint32_t slot) const;
  std::vector<std::uint32_t> slots_near(const Aabb& own_box) const;
  void check_poses_of_parts(const Pose& pose, double deviation) const;
  std::optional<Ray> own_ray(const Pose& pose, const Ray& ray, double& skipped) const;

  Compound compound_;
  std::vector<Slot> slots_;  ///< numbers ascending
  // Boxes of the parts in the compound's frame, with kIndexRoom: a few in a list, more looked up.
  std::vector<Aabb> few_boxes_;
  std::unique_ptr<BroadPhase> boxes_;  ///< by indices of slots
  Aabb own_;                           ///< around all of these
  double radius_ = 0;
  double deviation_ = 0;  ///< of a part's pose from a rotation, at most
};

/// The shape as a compound, or nullptr.
const CompoundBody* as_compound(const BodyShape& shape);

/// Whether a part's filter of its own lets it meet what has such a filter, where both are known.
bool lets_part_meet(const Filter* part, const std::optional<Filter>& other);

}  // namespace graze
