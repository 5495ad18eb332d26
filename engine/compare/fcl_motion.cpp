#include <graze/engine/compare/fcl_geometry.h>
#include <graze/engine/compare/fcl_motion.h>

#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <cmath>
#include <utility>

// See fcl_engine.cpp.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::compare {

struct FclMover::Geometry {
  FclGeometry value;
  bool has_no_end;
};

namespace {

/// Beyond it the short way, which FCL takes, may be another.
constexpr double kMostTurnedByFcl = 3;

/// FCL 0.7's advancement dies of SIGSEGV with them.
bool has_no_end(const Shape& shape) {
  return shape.kind() == ShapeKind::HalfSpace || shape.kind() == ShapeKind::Plane;
}

/// FCL names the point that goes straight in the frame of the geometry.
fcl::InterpMotion<double> to_fcl(const RigidMotion& motion, const FclGeometry& shape) {
  const fcl::Transform3d start = fcl_transform(motion.start(), shape.centre);
  const fcl::Transform3d end = fcl_transform(motion.at(1), shape.centre);
  const fcl::Vector3d centre = start.inverse() * fcl::Vector3d(motion.centre());
  // The one that takes whole transforms leaves the velocities as they were in memory.
  return {start.linear(), start.translation(), end.linear(), end.translation(), centre};
}

}  // namespace

FclMover::FclMover(const Shape& shape)
    : geometry_(std::make_unique<Geometry>(Geometry{fcl_geometry(shape), has_no_end(shape)})) {}
FclMover::~FclMover() = default;
FclMover::FclMover(FclMover&&) noexcept = default;

std::optional<FclFirstContact> first_contact(const FclMover& shape_a, const RigidMotion& motion_a,
                                             const FclMover& shape_b, const RigidMotion& motion_b,
                                             FclContinuous how) {
  for (const RigidMotion* motion : {&motion_a, &motion_b})
    if (std::abs(motion->angle()) >= kMostTurnedByFcl) return std::nullopt;
  if (how == FclContinuous::Advanced &&
      (shape_a.geometry_->has_no_end || shape_b.geometry_->has_no_end))
    return std::nullopt;
  const FclGeometry &a = shape_a.geometry_->value, &b = shape_b.geometry_->value;
  const fcl::InterpMotion<double> course_a = to_fcl(motion_a, a), course_b = to_fcl(motion_b, b);
  fcl::ContinuousCollisionRequestd request;
  if (how == FclContinuous::Advanced) request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  fcl::ContinuousCollisionResultd result;
  const double time = fcl::continuousCollide(a.geometry.get(), &course_a, b.geometry.get(),
                                             &course_b, request, result);
  if (time < 0) return std::nullopt;  // its word for what it has no function for
  return FclFirstContact{result.is_collide, result.is_collide ? result.time_of_contact : 1};
}

}  // namespace graze::compare
