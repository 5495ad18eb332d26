#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/query/batch.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/world/body_shapes/users_shape.h>
#include <graze/engine/world/rigid/moving_shape.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/world_batch.h>

#include <algorithm>

namespace graze {
namespace {

/// The most elements of a part. They are so many that even elements that meet nothing take longer
/// than starting the part.
constexpr std::size_t kMostInAPartOfWorldBatch = 64;
/// The most motions of a part: their costs differ a thousandfold.
constexpr std::size_t kMostMotionsInAPart = 8;

bool allows_concurrent_calls(const BodyShape& shape) {
  const bool is_users = is_users_shape(shape);
  return !is_users || ask_shape(is_users, [&] { return shape.allows_concurrent_calls(); });
}

/// Returns the settings as they were given, but with one thread if the shape of a body asks for
/// that. It costs O(bodies).
BatchSettings settings_for(const World& world, const BatchSettings& batch) {
  check_threads(batch.threads);
  BatchSettings settings = batch;
  if (batch.threads == 1) return settings;
  const std::vector<BodyId> bodies = world.bodies();
  if (!std::all_of(bodies.begin(), bodies.end(),
                   [&](BodyId id) { return allows_concurrent_calls(world.shape(id)); }))
    settings.threads = 1;
  return settings;
}

/// Returns `ask(i)` for each element, in order. If that throws, it calls `check(i)` for each, which
/// throws an error that names the first element that is to blame. Checking all elements first would
/// take a tenth of the time of short questions, and could not be stopped.
template <typename Answer, typename Ask, typename Check>
std::vector<Answer> ask_world_for_all(const World& world, std::size_t count,
                                      std::size_t most_in_a_part, const BatchSettings& batch,
                                      const Ask& ask, const Check& check) {
  const BatchSettings settings = settings_for(world, batch);
  std::vector<Answer> answers(count);
  try {
    for_each_in_batch(count, most_in_a_part, settings, nullptr,
                      [&](std::size_t i, Work&) { answers[i] = ask(i); });
  } catch (const StoppedError&) {
    throw;
  } catch (const Error&) {
    for (std::size_t i = 0; i < count; ++i)
      check(i);
    throw;
  }
  return answers;
}

/// Returns `ask(ray)` for each ray.
template <typename Answer, typename Ask>
std::vector<Answer> ask_world_along(const World& world, std::span<const Ray> rays,
                                    const BatchSettings& batch, const Ask& ask) {
  return ask_world_for_all<Answer>(
      world, rays.size(), kMostInAPartOfWorldBatch, batch,
      [&](std::size_t i) { return ask(rays[i]); },
      [&](std::size_t i) {
        bvh::check_element("ray", i, "", [&](const char* what) { check_ray(rays[i], what); });
      });
}

/// Returns `ask(placed)` for the shape in each pose.
template <typename Answer, typename Ask>
std::vector<Answer> ask_world_in_poses(const World& world, const ShapeInPoses& placed,
                                       const BatchSettings& batch, const Ask& ask) {
  return ask_world_for_all<Answer>(
      world, placed.poses.size(), kMostInAPartOfWorldBatch, batch,
      [&](std::size_t i) { return ask(PlacedShapeView(placed.shape, placed.poses[i])); },
      [&](std::size_t i) {
        bvh::check_element("pose", i, "", [&](const char* what) {
          check_pose(placed.poses[i], what);
          static_cast<void>(bounding_aabb({placed.shape, placed.poses[i]}));
        });
      });
}

/// Returns `ask(motion)` for each motion.
template <typename Answer, typename Ask>
std::vector<Answer> ask_world_in_motions(const World& world, const ShapeInMotions& moved,
                                         const RigidContactSettings& contact,
                                         const BatchSettings& batch, const Ask& ask) {
  check_settings(contact);
  return ask_world_for_all<Answer>(
      world, moved.motions.size(), kMostMotionsInAPart, batch,
      [&](std::size_t i) { return ask(moved.motions[i]); },
      [&](std::size_t i) {
        bvh::check_element("motion", i, "", [&](const char* what) {
          static_cast<void>(MovingShape(moved.shape, moved.motions[i], what));
        });
      });
}

}  // namespace

std::vector<std::optional<BodyRayHit>> cast_rays(const World& world, std::span<const Ray> rays,
                                                 const BodyQuerySettings& settings,
                                                 const BatchSettings& batch) {
  using FirstHit = std::optional<BodyRayHit>;
  return bvh::in_standard_arithmetic([&]() -> std::vector<FirstHit> {
    return ask_world_along<FirstHit>(world, rays, batch,
                                     [&](const Ray& ray) { return world.cast_ray(ray, settings); });
  });
}

std::vector<std::vector<BodyRayHit>> cast_ray_all(const World& world, std::span<const Ray> rays,
                                                  const BodyQuerySettings& settings,
                                                  const BatchSettings& batch) {
  using Hits = std::vector<BodyRayHit>;
  return bvh::in_standard_arithmetic([&]() -> std::vector<Hits> {
    return ask_world_along<Hits>(world, rays, batch,
                                 [&](const Ray& ray) { return world.cast_ray_all(ray, settings); });
  });
}

std::vector<std::vector<BodyId>> find_touching(const World& world, const ShapeInPoses& shape,
                                               const BodyQuerySettings& settings,
                                               const BatchSettings& batch) {
  using Touching = std::vector<BodyId>;
  return bvh::in_standard_arithmetic([&]() -> std::vector<Touching> {
    return ask_world_in_poses<Touching>(world, shape, batch, [&](const PlacedShapeView& placed) {
      return world.find_touching(placed, settings);
    });
  });
}

std::vector<std::vector<BodyDistance>> find_within(const World& world, const ShapeInPoses& shape,
                                                   double clearance,
                                                   const BodyQuerySettings& settings,
                                                   const BatchSettings& batch) {
  using Near = std::vector<BodyDistance>;
  return bvh::in_standard_arithmetic([&]() -> std::vector<Near> {
    return ask_world_in_poses<Near>(world, shape, batch, [&](const PlacedShapeView& placed) {
      return world.find_within(placed, clearance, settings);
    });
  });
}

std::vector<std::optional<BodyDistance>> find_closest(const World& world, const ShapeInPoses& shape,
                                                      const BodyQuerySettings& settings,
                                                      const BatchSettings& batch) {
  using Closest = std::optional<BodyDistance>;
  return bvh::in_standard_arithmetic([&]() -> std::vector<Closest> {
    return ask_world_in_poses<Closest>(world, shape, batch, [&](const PlacedShapeView& placed) {
      return world.find_closest(placed, settings);
    });
  });
}

std::vector<std::optional<BodyCast>> cast(const World& world, const ShapeInMotions& shape,
                                          const RigidContactSettings& contact,
                                          const BodyQuerySettings& settings,
                                          const BatchSettings& batch) {
  using First = std::optional<BodyCast>;
  return bvh::in_standard_arithmetic([&]() -> std::vector<First> {
    return ask_world_in_motions<First>(
        world, shape, contact, batch, [&](const RigidMotion& motion) {
          return world.cast({shape.shape, motion}, contact, settings);
        });
  });
}

std::vector<std::vector<BodyCast>> cast_all(const World& world, const ShapeInMotions& shape,
                                            const RigidContactSettings& contact,
                                            const BodyQuerySettings& settings,
                                            const BatchSettings& batch) {
  using Casts = std::vector<BodyCast>;
  return bvh::in_standard_arithmetic([&]() -> std::vector<Casts> {
    return ask_world_in_motions<Casts>(
        world, shape, contact, batch, [&](const RigidMotion& motion) {
          return world.cast_all({shape.shape, motion}, contact, settings);
        });
  });
}

}  // namespace graze
