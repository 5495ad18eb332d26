#pragma once

// The BodyShape of a compound. Private to engine/world.

#include <graze/engine/world/body_shapes/part_tree.h>
#include <graze/engine/world/body_shapes/parts_body.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/compound.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace graze {

/// A compound as a body of parts. A part has the number that the compound gave it.
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
  std::vector<std::uint32_t> numbers_;  ///< ascending; the place of a part is its index here
  std::vector<std::shared_ptr<const BodyShape>> shapes_;  ///< by number
  /// The boxes of the parts in the compound's frame, with room. A few are kept in a list, more in a
  /// broad phase.
  std::vector<Aabb> few_boxes_;        ///< by place
  std::unique_ptr<BroadPhase> boxes_;  ///< by place
  // A tree over the boxes of many parts, without room. It is built when the nearest part is first
  // asked for.
  mutable std::once_flag tree_flag_;
  mutable std::unique_ptr<const PartTree> tree_;
};

}  // namespace graze
