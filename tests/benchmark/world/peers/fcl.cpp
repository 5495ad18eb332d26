// FCL's dynamic tree of boxes, and its collide() with contacts for each pair whose boxes overlap;
// meshes are trees of OBBRSS. It does not choose among contacts: with a limit it stops at the first
// ones that it comes across, without it hands out one for each pair of triangles.

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include "tests/benchmark/common/fcl_models.h"
#include "tests/benchmark/world/peers/peers.h"

namespace graze::benchmark {
namespace {

struct Found {
  fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  std::vector<fcl::Contactd> contacts;
  Counts counts;
};

bool on_pair(fcl::CollisionObjectd* s, fcl::CollisionObjectd* t, void* data) {
  Found& found = *static_cast<Found*>(data);
  found.result.clear();
  fcl::collide(s, t, found.request, found.result);
  found.counts.pairs += found.result.isCollision();
  for (std::size_t i = 0; i < found.result.numContacts(); ++i)
    found.contacts.push_back(found.result.getContact(i));
  found.counts.contacts = found.contacts.size();
  return false;
}

class Fcl final : public Contestant {
 public:
  explicit Fcl(std::size_t limit) {
    found_.request.num_max_contacts = limit;
    found_.request.enable_contact = true;
  }

  void start(const Scene& scene, const Frame& frame) override {
    std::vector<std::shared_ptr<fcl::CollisionGeometryd>> kinds;
    for (const Kind& kind : scene.kinds)
      kinds.push_back(geometry(kind.shape));
    ground_ = std::make_unique<fcl::CollisionObjectd>(to_fcl<fcl::OBBRSSd>(scene.ground));
    for (std::size_t i = 0; i < frame.size(); ++i) {
      objects_.push_back(
          std::make_unique<fcl::CollisionObjectd>(kinds[scene.bodies[i]], to_fcl_pose(frame[i])));
      manager_.registerObject(objects_.back().get());
    }
    manager_.registerObject(ground_.get());
    manager_.setup();
    step(frame);
  }

  Counts step(const Frame& frame) override {
    for (std::size_t i = 0; i < frame.size(); ++i) {
      objects_[i]->setTransform(to_fcl_pose(frame[i]));
      objects_[i]->computeAABB();
    }
    manager_.update();
    found_.counts = {};
    found_.contacts.clear();
    manager_.collide(&found_, on_pair);
    return found_.counts;
  }

 private:
  static std::shared_ptr<fcl::CollisionGeometryd> geometry(const Shape& shape) {
    if (const Box* box = shape.as<Box>()) {
      const Eigen::Vector3d side = 2 * box->half_extents;
      return std::make_shared<fcl::Boxd>(side.x(), side.y(), side.z());
    }
    if (const Sphere* sphere = shape.as<Sphere>())
      return std::make_shared<fcl::Sphered>(sphere->radius);
    return to_fcl<fcl::OBBRSSd>(*shape.as<Mesh>());
  }

  Found found_;
  std::unique_ptr<fcl::CollisionObjectd> ground_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

}  // namespace

void add_fcl(std::vector<Entry>& entries) {
  entries.push_back({"FCL, all contacts", [] { return std::make_unique<Fcl>(100000); }});
  entries.push_back({"FCL, the first four", [] { return std::make_unique<Fcl>(4); }});
}

}  // namespace graze::benchmark
