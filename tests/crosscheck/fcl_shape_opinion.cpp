// All of FCL that the tests of shapes see: its headers take long to compile.

#include "tests/crosscheck/fcl_shape_opinion.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <graze/narrowphase/convex/hull.h>

#include <algorithm>
#include <memory>
#include <vector>

// The linked FCL was compiled for the baseline (engine/compare/fcl_engine.cpp).
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::tests {
namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

struct FclShape {
  Geometry geometry;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // FCL's spheres and ellipsoids are at 0
};

FclShape converted(const Sphere& s) {
  return {std::make_shared<fcl::Sphered>(s.radius), s.centre};
}

FclShape converted(const Box& s) {
  const Eigen::Vector3d sides = 2 * s.half_extents;
  return {std::make_shared<fcl::Boxd>(sides.x(), sides.y(), sides.z())};
}

FclShape converted(const Capsule& s) {
  return {std::make_shared<fcl::Capsuled>(s.radius, 2 * s.half_length)};
}

FclShape converted(const Cylinder& s) {
  return {std::make_shared<fcl::Cylinderd>(s.radius, 2 * s.half_height)};
}

FclShape converted(const Cone& s) {
  return {std::make_shared<fcl::Coned>(s.radius, 2 * s.half_height)};
}

FclShape converted(const Ellipsoid& s) {
  const Eigen::Vector3d& a = s.semi_axes;
  return {std::make_shared<fcl::Ellipsoidd>(a.x(), a.y(), a.z()), s.centre};
}

FclShape converted(const HalfSpace& s) {
  return {std::make_shared<fcl::Halfspaced>(s.normal, s.offset)};
}

FclShape converted(const ConvexHull& s) {
  const narrowphase::Hull& hull = s.data();
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const auto& c : hull.corners)
    vertices->emplace_back(c.x, c.y, c.z);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& face : hull.faces) {
    faces->push_back(static_cast<int>(face.count));
    for (std::uint32_t i = 0; i < face.count; ++i)
      faces->push_back(static_cast<int>(hull.loops[face.first + i]));
  }
  const int count = static_cast<int>(hull.faces.size());
  return {std::make_shared<fcl::Convexd>(vertices, count, faces),
          {hull.middle.x, hull.middle.y, hull.middle.z}};
}

FclShape converted(const Mesh& mesh) {
  std::vector<fcl::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<fcl::Triangle> triangles;
  for (const TriangleIndices& t : mesh.triangles())
    triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  model->beginModel();
  model->addSubModel(vertices, triangles);
  model->endModel();
  return {model};
}

fcl::Transform3d transform_of(const Pose& pose, const Eigen::Vector3d& centre) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = pose.linear();
  transform.translation() = pose * centre;
  return transform;
}

bool has_distance(const Shape& shape) {
  return shape.kind() != ShapeKind::HalfSpace && shape.kind() != ShapeKind::Mesh;
}

}  // namespace

struct FclPair::Objects {
  fcl::CollisionObjectd a;
  fcl::CollisionObjectd b;
};

FclPair::FclPair(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  const auto convert = [](const auto& shape) { return converted(shape); };
  const FclShape fcl_a = std::visit(convert, a.value());
  const FclShape fcl_b = std::visit(convert, b.value());
  objects_ = std::make_unique<Objects>(
      Objects{fcl::CollisionObjectd(fcl_a.geometry, transform_of(pose_a, fcl_a.centre)),
              fcl::CollisionObjectd(fcl_b.geometry, transform_of(pose_b, fcl_b.centre))});
}

FclPair::~FclPair() = default;
FclPair::FclPair(FclPair&&) noexcept = default;

bool FclPair::intersects() const {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(&objects_->a, &objects_->b, request, result) > 0;
}

FclOpinion FclPair::contacts() const {
  const fcl::CollisionRequestd request(4, true);
  fcl::CollisionResultd result;
  FclOpinion opinion{};
  opinion.is_hit = fcl::collide(&objects_->a, &objects_->b, request, result) > 0;
  for (std::size_t i = 0; i < result.numContacts(); ++i)
    opinion.depth = std::max(opinion.depth, result.getContact(i).penetration_depth);
  return opinion;
}

double FclPair::distance() const {
  fcl::DistanceRequestd asked(true);
  asked.distance_tolerance = 1e-10;
  fcl::DistanceResultd found;
  return fcl::distance(&objects_->a, &objects_->b, asked, found);
}

FclOpinion ask_fcl(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  const FclPair pair(a, pose_a, b, pose_b);
  FclOpinion opinion = pair.contacts();
  // FCL 0.7 asks a half-space for a support function that it does not have, and crashes.
  if (has_distance(a) && has_distance(b)) opinion.distance = pair.distance();
  return opinion;
}

}  // namespace graze::tests
