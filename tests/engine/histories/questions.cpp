#include "tests/engine/histories/questions.h"

#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace graze::tests {
namespace {

bool are_equal(const ShapeDistance& s, const ShapeDistance& t) {
  return s.distance == t.distance && s.lower_bound == t.lower_bound && s.point_a == t.point_a &&
         s.point_b == t.point_b && s.normal == t.normal && s.status == t.status;
}

bool are_equal(const RayHit& s, const RayHit& t) {
  return s.distance == t.distance && s.point == t.point && s.normal == t.normal &&
         s.triangle == t.triangle;
}

/// Bodies by id, as the world lists them.
class Asked {
 public:
  Asked(const World& world, const Oracle& oracle, const std::map<BodyId, std::uint32_t>& names)
      : world_(world), oracle_(oracle) {
    for (const auto& [id, name] : names) {
      if (oracle.has(name) && world.contains(id) && world.user_data(id) == name)
        bodies_.push_back({id, name});
    }
    expect(bodies_.size() == oracle.beings().size(), "bodies are missing");
  }

  std::size_t touching(const Shape& shape, const Pose& pose) const {
    std::vector<BodyId> wanted;
    for (const auto& [id, name] : bodies_) {
      if (intersects({shape, pose}, {oracle_.shape_of(name), pose_of(name)})) wanted.push_back(id);
    }
    expect(world_.find_touching({shape, pose}) == wanted, "find_touching() differs");
    return wanted.size();
  }

  std::size_t within(const Shape& shape, const Pose& pose, double clearance) const {
    std::vector<BodyDistance> wanted;
    for (const auto& [id, name] : bodies_) {
      const ShapeDistance way = distance({shape, pose}, {oracle_.shape_of(name), pose_of(name)});
      if (way.distance <= clearance) wanted.push_back({id, way});
    }
    const std::vector<BodyDistance> found = world_.find_within({shape, pose}, clearance);
    const bool is_same = std::equal(
        found.begin(), found.end(), wanted.begin(), wanted.end(),
        [](auto& s, auto& t) { return s.id == t.id && are_equal(s.distance, t.distance); });
    expect(is_same, "find_within() differs: " + std::to_string(found.size()) + " bodies, not " +
                        std::to_string(wanted.size()));
    return wanted.size();
  }

  std::size_t closest(const Shape& shape, const Pose& pose) const {
    std::optional<BodyDistance> wanted;
    for (const auto& [id, name] : bodies_) {
      const ShapeDistance way = distance({shape, pose}, {oracle_.shape_of(name), pose_of(name)});
      if (!wanted || way.distance < wanted->distance.distance) wanted = BodyDistance{id, way};
    }
    const std::optional<BodyDistance> found = world_.find_closest({shape, pose});
    expect(found.has_value() == wanted.has_value(), "find_closest() differs");
    expect(!found || (found->id == wanted->id && are_equal(found->distance, wanted->distance)),
           "find_closest() finds another body, or says otherwise how far it is");
    return wanted ? 1 : 0;
  }

  std::size_t ray(const Ray& ray) const {
    std::vector<BodyRayHit> wanted;
    for (const auto& [id, name] : bodies_) {
      if (const auto hit = cast_ray({oracle_.shape_of(name), pose_of(name)}, ray))
        wanted.push_back({id, *hit});
    }
    std::sort(wanted.begin(), wanted.end(), [](const BodyRayHit& s, const BodyRayHit& t) {
      return std::tie(s.hit.distance, s.id) < std::tie(t.hit.distance, t.id);
    });
    const auto is_same = [](const BodyRayHit& s, const BodyRayHit& t) {
      return s.id == t.id && are_equal(s.hit, t.hit);
    };
    const std::vector<BodyRayHit> found = world_.cast_ray_all(ray);
    expect(std::equal(found.begin(), found.end(), wanted.begin(), wanted.end(), is_same),
           "cast_ray_all() differs: " + std::to_string(found.size()) + " bodies, not " +
               std::to_string(wanted.size()));
    const std::optional<BodyRayHit> first = world_.cast_ray(ray);
    expect(first.has_value() == !wanted.empty() && (!first || is_same(*first, wanted[0])),
           "cast_ray() differs");
    return wanted.size();
  }

  std::size_t box(const Aabb& box) const {
    std::vector<BodyId> wanted;
    for (const auto& [id, name] : bodies_) {
      const Aabb own = bounding_aabb({oracle_.shape_of(name), pose_of(name)});
      bool is_there = true;
      for (int k = 0; k < 3; ++k)
        is_there = is_there && own.min[k] <= box.max[k] && box.min[k] <= own.max[k];
      if (is_there) wanted.push_back(id);
    }
    expect(world_.find_in_box(box) == wanted, "find_in_box() differs");
    return wanted.size();
  }

 private:
  struct Known {
    BodyId id;
    std::uint32_t name;
  };

  const Pose& pose_of(std::uint32_t name) const { return oracle_.beings().at(name).pose; }

  const World& world_;
  const Oracle& oracle_;
  std::vector<Known> bodies_;  // ascending
};

}  // namespace

void expect(bool is_true, const std::string& what) {
  if (!is_true) throw std::runtime_error(what);
}

std::size_t check_answer(const Operation& question, const World& world, const Oracle& oracle,
                         const std::map<BodyId, std::uint32_t>& names) {
  const Asked asked(world, oracle, names);
  const auto vector = [&](std::size_t i) {
    return Eigen::Vector3d(question.values[i], question.values[i + 1], question.values[i + 2]);
  };
  switch (question.verb) {
    case Verb::AskRay:
      return asked.ray({vector(0), vector(3), question.values[6]});
    case Verb::AskBox:
      return asked.box({vector(0), vector(3)});
    case Verb::AskTouching:
      return asked.touching(oracle.palette()[question.number], question.pose);
    case Verb::AskWithin:
      return asked.within(oracle.palette()[question.number], question.pose, question.values[0]);
    case Verb::AskClosest:
      return asked.closest(oracle.palette()[question.number], question.pose);
    default:
      throw std::logic_error("not a question");
  }
}

}  // namespace graze::tests
