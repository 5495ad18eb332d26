#include <graze/engine/compare/fcl_geometry.h>
#include <graze/engine/compare/fcl_motion.h>

#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>
#include <fcl/math/motion/spline_motion.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <cmath>
#include <utility>
#include <vector>

// See fcl_engine.cpp.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::compare {

struct FclMover::Geometry {
  FclGeometry value;
  Shape shape;

  /// True for shapes with which FCL 0.7's advancement dies of SIGSEGV.
  bool has_no_end() const {
    return shape.kind() == ShapeKind::HalfSpace || shape.kind() == ShapeKind::Plane;
  }
};

namespace {

using FclMotionPointer = std::shared_ptr<fcl::MotionBase<double>>;

/// Beyond this angle the short way, which FCL takes, may be another.
constexpr double kMostTurnedByFcl = 3;

/// A shift may lead this far from its axis, as a share of itself: a shift that was meant to lie
/// along it does after rounding.
constexpr double kAcrossTheAxis = 0x1p-40;

bool is_screw(const RigidMotion& motion) {
  const Eigen::Vector3d& shift = motion.shift();
  return motion.angle() == 0 || shift.cross(motion.axis()).norm() <= kAcrossTheAxis * shift.norm();
}

bool can_go(FclCourse course, const RigidMotion& motion) {
  if (std::abs(motion.angle()) >= kMostTurnedByFcl) return false;
  if (course == FclCourse::Interpolated) return true;
  return course == FclCourse::Screw ? is_screw(motion) : motion.angle() == 0;
}

/// Makes a spline. If its four points lie evenly in a line it goes from the second to the third,
/// steadily. The constructor of two poses leaves it as it was in memory.
FclMotionPointer spline(const fcl::Transform3d& start, const fcl::Vector3d& shift) {
  const fcl::AngleAxisd turned(start.linear());
  const fcl::Vector3d r = turned.angle() * turned.axis();
  const fcl::Vector3d t = start.translation();
  return std::make_shared<fcl::SplineMotion<double>>(t - shift, t, t + shift, t + 2 * shift, r, r,
                                                     r, r);
}

/// Makes a motion. FCL names the point that goes straight in the frame of the geometry.
FclMotionPointer interpolated(const fcl::Transform3d& start, const fcl::Transform3d& end,
                              const Eigen::Vector3d& centre) {
  const fcl::Vector3d inside = start.inverse() * fcl::Vector3d(centre);
  // The constructor that takes whole transforms leaves the velocities as they were in memory.
  return std::make_shared<fcl::InterpMotion<double>>(start.linear(), start.translation(),
                                                     end.linear(), end.translation(), inside);
}

FclMotionPointer to_fcl(const RigidMotion& motion, const FclGeometry& shape, FclCourse course) {
  const fcl::Transform3d start = fcl_transform(motion.start(), shape.centre);
  const fcl::Transform3d end = fcl_transform(motion.at(1), shape.centre);
  switch (course) {
    case FclCourse::Screw:
      return std::make_shared<fcl::ScrewMotion<double>>(start, end);
    case FclCourse::Translation:
      return std::make_shared<fcl::TranslationMotion<double>>(start, end);
    case FclCourse::Spline:
      return spline(start, motion.shift());
    default:
      return interpolated(start, end, motion.centre());
  }
}

/// Holds a mesh and its motion, as FCL's polynomials know them: they look at no pose, so that the
/// vertices are placed; and they move the vertices that they are given, so that each question gets
/// its own.
struct StraightMesh {
  FclGeometry geometry;
  fcl::TranslationMotion<double> motion;
};

StraightMesh straight(const Mesh& mesh, const RigidMotion& motion) {
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(mesh.vertices().size());
  for (const Eigen::Vector3d& vertex : mesh.vertices())
    vertices.emplace_back(motion.start() * vertex);
  fcl::Transform3d end = fcl::Transform3d::Identity();
  end.translation() = motion.shift();
  return {fcl_geometry(Mesh(vertices, mesh.triangles())),
          fcl::TranslationMotion<double>(fcl::Transform3d::Identity(), end)};
}

fcl::ContinuousCollisionRequestd request_of(const FclMotionSettings& settings) {
  fcl::ContinuousCollisionRequestd request;
  request.num_max_iterations = settings.samples;
  request.toc_err = settings.time_error;
  request.gjk_solver_type =
      settings.nearest == FclNearest::Independent ? fcl::GST_INDEP : fcl::GST_LIBCCD;
  request.ccd_solver_type = settings.how == FclContinuous::Sampled ? fcl::CCDC_NAIVE
                            : settings.how == FclContinuous::Advanced
                                ? fcl::CCDC_CONSERVATIVE_ADVANCEMENT
                                : fcl::CCDC_POLYNOMIAL_SOLVER;
  return request;
}

std::optional<FclFirstContact> answer(const fcl::CollisionGeometryd& a,
                                      const fcl::MotionBase<double>& course_a,
                                      const fcl::CollisionGeometryd& b,
                                      const fcl::MotionBase<double>& course_b,
                                      const FclMotionSettings& settings) {
  fcl::ContinuousCollisionResultd result;
  const double time =
      fcl::continuousCollide(&a, &course_a, &b, &course_b, request_of(settings), result);
  if (time < 0) return std::nullopt;  // FCL says so if it has no function for them
  return FclFirstContact{result.is_collide, result.is_collide ? result.time_of_contact : 1};
}

}  // namespace

FclMover::FclMover(const Shape& shape)
    : geometry_(std::make_unique<Geometry>(Geometry{fcl_geometry(shape), shape})) {}
FclMover::~FclMover() = default;
FclMover::FclMover(FclMover&&) noexcept = default;

std::optional<FclFirstContact> first_contact(const FclMover& shape_a, const RigidMotion& motion_a,
                                             const FclMover& shape_b, const RigidMotion& motion_b,
                                             const FclMotionSettings& settings) {
  if (settings.order == FclOrder::Swapped) {
    FclMotionSettings kept = settings;
    kept.order = FclOrder::Kept;
    return first_contact(shape_b, motion_b, shape_a, motion_a, kept);
  }
  if (!can_go(settings.course, motion_a) || !can_go(settings.course, motion_b)) return std::nullopt;
  const FclMover::Geometry &a = *shape_a.geometry_, &b = *shape_b.geometry_;
  if (settings.how == FclContinuous::Polynomial) {
    const Mesh *mesh_a = a.shape.as<Mesh>(), *mesh_b = b.shape.as<Mesh>();
    if (mesh_a == nullptr || mesh_b == nullptr) return std::nullopt;
    const StraightMesh one = straight(*mesh_a, motion_a), two = straight(*mesh_b, motion_b);
    return answer(*one.geometry.geometry, one.motion, *two.geometry.geometry, two.motion, settings);
  }
  if (settings.how == FclContinuous::Advanced && (a.has_no_end() || b.has_no_end()))
    return std::nullopt;
  const FclMotionPointer course_a = to_fcl(motion_a, a.value, settings.course);
  const FclMotionPointer course_b = to_fcl(motion_b, b.value, settings.course);
  return answer(*a.value.geometry, *course_a, *b.value.geometry, *course_b, settings);
}

}  // namespace graze::compare
