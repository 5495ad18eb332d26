// FCL's dynamic tree of boxes, asked about an object that is not in it: collide() and distance(),
// its own solver, without contacts and points.

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/distance.h>

#include <limits>

#include "tests/benchmark/common/fcl_models.h"
#include "tests/benchmark/world_batches/peer.h"

namespace graze::benchmark {
namespace {

std::shared_ptr<fcl::CollisionGeometryd> to_fcl(const Shape& shape) {
  if (const auto* ball = shape.as<Sphere>()) return std::make_shared<fcl::Sphered>(ball->radius);
  const Eigen::Vector3d side = 2 * shape.as<Box>()->half_extents;
  return std::make_shared<fcl::Boxd>(side.x(), side.y(), side.z());
}

/// Notes all that touch, as find_touching() does.
bool on_pair(fcl::CollisionObjectd* s, fcl::CollisionObjectd* t, void* data) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  fcl::collide(s, t, request, result);
  *static_cast<std::size_t*>(data) += result.isCollision();
  return false;
}

bool on_distance(fcl::CollisionObjectd* s, fcl::CollisionObjectd* t, void* data, double& least) {
  double& best = *static_cast<double*>(data);
  const fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  best = std::min(best, fcl::distance(s, t, request, result));
  least = best;
  return best <= 0;
}

class Fcl final : public BatchPeer {
 public:
  explicit Fcl(const Questions& all) : probe_(to_fcl(all.probe)) {
    for (const PlacedShape& body : all.bodies) {
      objects_.push_back(
          std::make_unique<fcl::CollisionObjectd>(to_fcl(body.shape), to_fcl_pose(body.pose)));
      manager_.registerObject(objects_.back().get());
    }
    manager_.setup();
  }

  std::string name() const override { return "FCL"; }

  std::optional<std::size_t> ask(Question question, const Questions& all) override {
    if (question != Question::Touching && question != Question::Closest) return std::nullopt;
    std::size_t hits = 0;
    for (const Pose& pose : all.poses) {
      probe_.setTransform(to_fcl_pose(pose));
      probe_.computeAABB();
      hits += question == Question::Touching ? touches() : least_distance() <= 0;
    }
    return hits;
  }

 private:
  bool touches() {
    std::size_t touching = 0;
    manager_.collide(&probe_, &touching, on_pair);
    return touching > 0;
  }

  double least_distance() {
    double least = std::numeric_limits<double>::max();
    manager_.distance(&probe_, &least, on_distance);
    return least;
  }

  fcl::CollisionObjectd probe_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

}  // namespace

std::unique_ptr<BatchPeer> make_fcl(const Questions& all) {
  return std::make_unique<Fcl>(all);
}

}  // namespace graze::benchmark
