// Finds which bodies a ray meets.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/body_shapes/parts_body.h>

#include <algorithm>
#include <functional>

namespace graze {
namespace {

bool is_before(const BodyRayHit& s, const BodyRayHit& t) {
  if (s.hit.distance != t.hit.distance) return s.hit.distance < t.hit.distance;
  return s.id < t.id;
}

}  // namespace

/// Calls `on_hit(hit)` for the bodies that the ray meets; `on_hit` returns how far to look from
/// then on, metres.
template <typename OnHit>
void World::State::for_each_hit(const Ray& ray, const BodyQuerySettings& query,
                                OnHit&& on_hit) const {
  Ray shorter = ray;
  const auto look = [&](std::uint32_t box) {
    // The world is a user of the broad phase, and is called as such.
    return bvh::in_standard_arithmetic([&] {
      const std::uint32_t index = body_of_box[box];
      const Bodies::Body& body = all.bodies[index];
      if (!is_asked_for(index, query)) return shorter.max_distance;
      if (const PartsBody* whole = as_parts(*body.shape)) {
        if (const auto found = whole->first_hit(body.pose, shorter, query.filter))
          shorter.max_distance = on_hit(BodyRayHit{all.id(index), found->hit, found->part});
        return shorter.max_distance;
      }
      const auto hit =
          body.ask([&](const BodyShape& shape) { return shape.cast_ray(body.pose, shorter); });
      if (hit) shorter.max_distance = on_hit(BodyRayHit{all.id(index), *hit});
      return shorter.max_distance;
    });
  };
  broad.visit_along(ray, std::cref(look));  // a reference, so that nothing is allocated
}

std::optional<BodyRayHit> World::cast_ray(const Ray& ray, const BodyQuerySettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::optional<BodyRayHit> {
    check_ray(ray, "cast_ray");
    std::optional<BodyRayHit> first;
    state_->for_each_hit(ray, settings, [&](const BodyRayHit& hit) {
      if (!first || is_before(hit, *first)) first = hit;
      return first->hit.distance;
    });
    return first;
  });
}

std::vector<BodyRayHit> World::cast_ray_all(const Ray& ray,
                                            const BodyQuerySettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyRayHit> {
    check_ray(ray, "cast_ray_all");
    std::vector<BodyRayHit> hits;
    state_->for_each_hit(ray, settings, [&](const BodyRayHit& hit) {
      hits.push_back(hit);
      return ray.max_distance;
    });
    std::sort(hits.begin(), hits.end(), is_before);
    return hits;
  });
}

}  // namespace graze
