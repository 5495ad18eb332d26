// All of FCL that the tests of shapes see: its headers take long to compile.

#include "tests/crosscheck/fcl_shape_opinion.h"

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <graze/engine/compare/fcl_geometry.h>

#include <algorithm>
#include <memory>

// The linked FCL was compiled for the baseline (engine/compare/fcl_engine.cpp).
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::tests {
namespace {

bool has_distance(const Shape& shape) {
  return shape.kind() != ShapeKind::HalfSpace && shape.kind() != ShapeKind::Plane;
}

}  // namespace

struct FclPair::Objects {
  fcl::CollisionObjectd a;
  fcl::CollisionObjectd b;
};

FclPair::FclPair(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  const compare::FclGeometry fcl_a = compare::fcl_geometry(a);
  const compare::FclGeometry fcl_b = compare::fcl_geometry(b);
  objects_ = std::make_unique<Objects>(
      Objects{fcl::CollisionObjectd(fcl_a.geometry, compare::fcl_transform(pose_a, fcl_a.centre)),
              fcl::CollisionObjectd(fcl_b.geometry, compare::fcl_transform(pose_b, fcl_b.centre))});
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
