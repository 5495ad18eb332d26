#pragma once

// A compound as a world asks it. Private to engine/world.

#include <graze/engine/world/body_shapes/part_tree.h>
#include <graze/engine/world/body_shapes/parts_body.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/compound.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace graze {

/// A part's number is that which the compound gave it.
class CompoundBody final : public PartsBody {
 public:
  /// Throws as share() does.
  explicit CompoundBody(const Compound& compound);

  const Compound& compound() const { return compound_; }

 private:
  OwnPart part(std::uint32_t number) const override;
  std::vector<std::uint32_t> parts_near(const Aabb& own_box) const override;
  std::vector<std::uint32_t> all_parts() const override { return numbers_; }
  void look_at_nearest(const std::optional<Aabb>& own_box, const GapToParts& gap, double limit,
                       const Look& look) const override;
  void visit_along(const Ray& own_ray, const Look& look) const override;
  void check_parts(const Pose& pose) const override;

  Compound compound_;
  std::vector<std::uint32_t> numbers_;  ///< ascending; parts go by their places in it
  std::vector<std::shared_ptr<const BodyShape>> shapes_;  ///< by number
  // Boxes of the parts in the compound's frame, with room: a few in a list, more looked up.
  std::vector<Aabb> few_boxes_;        ///< by place
  std::unique_ptr<BroadPhase> boxes_;  ///< by place
  // Of many, without room, from when the nearest of them is asked for.
  mutable std::once_flag tree_flag_;
  mutable std::unique_ptr<const PartTree> tree_;
};

}  // namespace graze
