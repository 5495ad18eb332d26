#pragma once

// Many rays at a world, or a shape in many poses in it, in one call that threads share.

#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/world/world.h>

#include <optional>
#include <span>
#include <vector>

namespace graze {

/// A shape in each of many poses, as the second argument of questions to a world:
/// `find_touching(world, {gripper, poses})`. It refers to both, which must outlive it.
struct ShapeInPoses {
  /// Refers to both.
  ShapeInPoses(const Shape& of_shape, std::span<const Pose> in_poses)
      : shape(of_shape), poses(in_poses) {}

  const Shape& shape;           ///< must outlive this
  std::span<const Pose> poses;  ///< must outlive this
};

// For each ray, or for each pose, in their order, what the World's own question of that name
// answers, bit for bit, whatever the number of threads. They throw as it does, before the first
// answer where a ray or a pose is to blame, which the error names by its index; and as
// BatchSettings says. Where a body has a shape of a user's own that does not allow concurrent calls
// (BodyShape::allows_concurrent_calls()), the calling thread alone asks. No body may be changed
// meanwhile, as during the single question.

/// World::cast_ray() for each ray.
std::vector<std::optional<BodyRayHit>> cast_rays(const World& world, std::span<const Ray> rays,
                                                 const BodyQuerySettings& settings = {},
                                                 const BatchSettings& batch = {});

/// World::find_touching() for each pose.
std::vector<std::vector<BodyId>> find_touching(const World& world, const ShapeInPoses& shape,
                                               const BodyQuerySettings& settings = {},
                                               const BatchSettings& batch = {});

/// World::find_within() for each pose.
std::vector<std::vector<BodyDistance>> find_within(const World& world, const ShapeInPoses& shape,
                                                   double clearance,
                                                   const BodyQuerySettings& settings = {},
                                                   const BatchSettings& batch = {});

/// World::find_closest() for each pose.
std::vector<std::optional<BodyDistance>> find_closest(const World& world, const ShapeInPoses& shape,
                                                      const BodyQuerySettings& settings = {},
                                                      const BatchSettings& batch = {});

}  // namespace graze
