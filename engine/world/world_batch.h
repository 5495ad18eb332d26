#pragma once

// Questions about many rays at a world, or about a shape in many poses or motions in it, in one
// call that threads share.

#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/world.h>

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace graze {

/// A shape in each of many poses, as the second argument of questions to a world:
/// `find_touching(world, {gripper, poses})`. It refers to the poses, which must outlive it.
struct ShapeInPoses {
  /// Refers to the poses.
  ShapeInPoses(Shape of_shape, std::span<const Pose> in_poses)
      : shape(std::move(of_shape)), poses(in_poses) {}

  Shape shape;                  ///< a handle, where it is a hull or a mesh
  std::span<const Pose> poses;  ///< must outlive this
};

/// A shape in each of many motions, as the second argument of questions to a world: `cast(world,
/// {gripper, motions})`. A straight motion is `RigidMotion(pose, {.shift = displacement})`. It
/// refers to the motions, which must outlive it.
struct ShapeInMotions {
  /// Refers to the motions.
  ShapeInMotions(Shape of_shape, std::span<const RigidMotion> in_motions)
      : shape(std::move(of_shape)), motions(in_motions) {}

  Shape shape;                           ///< a handle, where it is a hull or a mesh
  std::span<const RigidMotion> motions;  ///< must outlive this
};

// For each ray, pose or motion, in their order, these functions return what the World's own
// function of that name returns, bit for bit, whatever the number of threads. They throw as it
// does, and as BatchSettings says; where rays, poses or motions are to blame, the error names the
// first of them by its index. Where a body has a user's own shape that does not allow concurrent
// calls (BodyShape::allows_concurrent_calls()), only the calling thread asks. No body may be
// changed meanwhile, as during a single question.

/// Calls World::cast_ray() for each ray.
std::vector<std::optional<BodyRayHit>> cast_rays(const World& world, std::span<const Ray> rays,
                                                 const BodyQuerySettings& settings = {},
                                                 const BatchSettings& batch = {});

/// Calls World::cast_ray_all() for each ray.
std::vector<std::vector<BodyRayHit>> cast_ray_all(const World& world, std::span<const Ray> rays,
                                                  const BodyQuerySettings& settings = {},
                                                  const BatchSettings& batch = {});

/// Calls World::find_touching() for each pose.
std::vector<std::vector<BodyId>> find_touching(const World& world, const ShapeInPoses& shape,
                                               const BodyQuerySettings& settings = {},
                                               const BatchSettings& batch = {});

/// Calls World::find_within() for each pose.
std::vector<std::vector<BodyDistance>> find_within(const World& world, const ShapeInPoses& shape,
                                                   double clearance,
                                                   const BodyQuerySettings& settings = {},
                                                   const BatchSettings& batch = {});

/// Calls World::find_closest() for each pose.
std::vector<std::optional<BodyDistance>> find_closest(const World& world, const ShapeInPoses& shape,
                                                      const BodyQuerySettings& settings = {},
                                                      const BatchSettings& batch = {});

/// Calls World::cast() for each motion.
std::vector<std::optional<BodyCast>> cast(const World& world, const ShapeInMotions& shape,
                                          const RigidContactSettings& contact = {},
                                          const BodyQuerySettings& settings = {},
                                          const BatchSettings& batch = {});

/// Calls World::cast_all() for each motion.
std::vector<std::vector<BodyCast>> cast_all(const World& world, const ShapeInMotions& shape,
                                            const RigidContactSettings& contact = {},
                                            const BodyQuerySettings& settings = {},
                                            const BatchSettings& batch = {});

}  // namespace graze
