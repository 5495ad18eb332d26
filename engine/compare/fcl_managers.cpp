#include <graze/engine/compare/fcl_geometry.h>
#include <graze/engine/compare/fcl_managers.h>
#include <graze/engine/compare/fcl_shapes.h>

#include <fcl/broadphase/broadphase_SSaP.h>
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_bruteforce.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/broadphase/broadphase_interval_tree.h>
#include <fcl/broadphase/broadphase_spatialhash.h>
#include <fcl/narrowphase/collision.h>
#include <algorithm>
#include <cmath>

// The linked FCL was compiled for the baseline (engine/compare/fcl_engine.cpp).
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::compare {
/// Holds a shape as FCL has it.
struct ShapeOfScene {
  FclGeometry fcl;
  ShapeKind kind;
};

/// Holds what a callback knows of a body.
struct BodyTag {
  std::size_t body;
  ShapeKind kind;
};

namespace {

using Manager = fcl::BroadPhaseCollisionManagerd;
using Objects = std::vector<fcl::CollisionObjectd*>;

/// FCL's own examples make so many cells along the longest side.
constexpr double kCells = 20;

/// Makes a hash of cells, which needs to know where its bodies are: those whose boxes end.
std::unique_ptr<Manager> hash_around(const Objects& objects) {
  fcl::AABBd all;
  bool is_empty = true;
  for (const fcl::CollisionObjectd* object : objects) {
    const fcl::AABBd& box = object->getAABB();
    const bool ends = (box.max_ - box.min_).norm() < 1e100;
    if (!ends) continue;
    all = is_empty ? box : all + box;
    is_empty = false;
  }
  if (is_empty) all = fcl::AABBd(fcl::Vector3d::Zero(), fcl::Vector3d::Ones());
  const double longest = std::max((all.max_ - all.min_).maxCoeff(), 1e-100);
  return std::make_unique<fcl::SpatialHashingCollisionManager<double>>(longest / kCells, all.min_,
                                                                       all.max_);
}

std::unique_ptr<Manager> manager_for(FclManager manager, const Objects& objects) {
  switch (manager) {
    case FclManager::Tree:
      return std::make_unique<fcl::DynamicAABBTreeCollisionManagerd>();
    case FclManager::TreeArray:
      return std::make_unique<fcl::DynamicAABBTreeCollisionManager_Arrayd>();
    case FclManager::Sap:
      return std::make_unique<fcl::SaPCollisionManagerd>();
    case FclManager::Ssap:
      return std::make_unique<fcl::SSaPCollisionManagerd>();
    case FclManager::IntervalTree:
      return std::make_unique<fcl::IntervalTreeCollisionManagerd>();
    case FclManager::SpatialHash:
      return hash_around(objects);
    default:
      return std::make_unique<fcl::NaiveCollisionManagerd>();
  }
}

/// True for a shape without an end: FCL 0.7 crashes when a tree of several bodies has one.
bool is_endless(ShapeKind kind) {
  return kind == ShapeKind::HalfSpace || kind == ShapeKind::Plane;
}

bool takes(FclManager manager, ShapeKind kind) {
  const bool is_tree = manager == FclManager::Tree || manager == FclManager::TreeArray;
  return !is_tree || !is_endless(kind);
}

using Found = std::vector<std::pair<std::size_t, std::size_t>>;

/// FCL's callback: true would end the walk.
bool add_if_colliding(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* found) {
  const auto* tag_a = static_cast<const BodyTag*>(a->getUserData());
  const auto* tag_b = static_cast<const BodyTag*>(b->getUserData());
  if (!fcl_knows(tag_a->kind, tag_b->kind)) return false;
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  if (fcl::collide(a, b, request, result) > 0)
    static_cast<Found*>(found)->push_back(std::minmax(tag_a->body, tag_b->body));
  return false;
}

}  // namespace

struct FclScene::Held {
  FclManager manager;
  std::vector<ShapeOfScene> shapes;
  // FCL's objects, and what they were made of, are kept as long as the bodies are the same ones,
  // whatever their poses: FCL measures a mesh when an object is made of it.
  std::vector<std::size_t> known;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
  std::vector<BodyTag> tags;

  void place(std::span<const FclBody> bodies) {
    const bool are_known = known.size() == bodies.size() &&
                           std::equal(bodies.begin(), bodies.end(), known.begin(),
                                      [](const FclBody& b, std::size_t s) { return b.shape == s; });
    if (!are_known) make_objects(bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const fcl::Transform3d there =
          fcl_transform(bodies[i].pose, shapes[bodies[i].shape].fcl.centre);
      objects[i]->setTransform(there);
      objects[i]->computeAABB();
    }
  }

 private:
  void make_objects(std::span<const FclBody> bodies) {
    known.clear();
    objects.clear();
    tags.clear();
    tags.reserve(bodies.size());  // objects point at them
    for (const FclBody& body : bodies) {
      const ShapeOfScene& shape = shapes[body.shape];
      known.push_back(body.shape);
      objects.push_back(std::make_unique<fcl::CollisionObjectd>(shape.fcl.geometry));
      tags.push_back({tags.size(), shape.kind});
      objects.back()->setUserData(&tags.back());
    }
  }
};

FclScene::FclScene(std::span<const Shape> shapes, FclManager manager)
    : held_(std::make_unique<Held>()) {
  held_->manager = manager;
  held_->shapes.reserve(shapes.size());
  for (const Shape& shape : shapes)
    held_->shapes.push_back({fcl_geometry(shape), shape.kind()});
}

FclScene::~FclScene() = default;

bool FclScene::knows(std::size_t shape_a, std::size_t shape_b) const {
  const ShapeKind a = held_->shapes[shape_a].kind;
  const ShapeKind b = held_->shapes[shape_b].kind;
  return fcl_knows(a, b) && takes(held_->manager, a) && takes(held_->manager, b);
}

Found FclScene::colliding(std::span<const FclBody> bodies) const {
  held_->place(bodies);
  Objects objects;
  objects.reserve(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (takes(held_->manager, held_->tags[i].kind)) objects.push_back(held_->objects[i].get());
  }
  const std::unique_ptr<Manager> manager = manager_for(held_->manager, objects);
  manager->registerObjects(objects);
  manager->setup();
  Found found;
  manager->collide(&found, add_if_colliding);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

const char* name_of(FclManager manager) {
  constexpr std::array kNames = {"fcl-tree",     "fcl-tree-array", "fcl-sap",  "fcl-ssap",
                                 "fcl-interval", "fcl-hash",       "fcl-naive"};
  return kNames[static_cast<std::size_t>(manager)];
}

}  // namespace graze::compare
