#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/compare/peers/bullet_casts.h>
#include <graze/engine/compare/peers/bullet_geometry.h>
#include <graze/engine/compare/peers/shape_answers.h>

#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <cmath>
#include <optional>

namespace graze::compare {

/// Holds a convex shape, a half-space or a mesh; or none of these, which Bullet does not cast.
class BulletCasts::Body {
 public:
  explicit Body(const Shape& shape) : centre_(bullet_centre(shape)), shape_(bullet_shape(shape)) {
    if (const Mesh* mesh = shape.as<Mesh>()) {
      triangles_ = std::make_unique<btTriangleMesh>();
      add_triangles(*mesh, *triangles_);
      mesh_ = std::make_unique<btBvhTriangleMeshShape>(triangles_.get(), kIsQuantized);
      mesh_->setMargin(0);
    }
  }

  const Eigen::Vector3d& centre() const { return centre_; }
  btBvhTriangleMeshShape* mesh() const { return mesh_.get(); }
  const btConvexShape* convex() const {
    return shape_ && shape_->isConvex() ? static_cast<const btConvexShape*>(shape_.get()) : nullptr;
  }
  const btStaticPlaneShape* half_space() const {
    const bool is_one = shape_ && shape_->getShapeType() == STATIC_PLANE_PROXYTYPE;
    return is_one ? static_cast<const btStaticPlaneShape*>(shape_.get()) : nullptr;
  }

 private:
  static constexpr bool kIsQuantized = true;  ///< the value that Bullet's users have

  Eigen::Vector3d centre_;
  std::unique_ptr<btCollisionShape> shape_;
  std::unique_ptr<btTriangleMesh> triangles_;
  std::unique_ptr<btBvhTriangleMeshShape> mesh_;
};

namespace {

/// Bullet goes no further in one step, radians.
constexpr double kMostTurnedByBullet = 0.25 * SIMD_PI;

/// An origin may lie this far from the axis, as a share of its distance to the centre, by rounding.
constexpr double kBesideTheAxis = 0x1p-40;

/// Holds a motion from one pose of Bullet's to another: the origin goes straight.
struct BulletMotion {
  btTransform from;
  btTransform to;
  bool turns;
};

btTransform bullet_pose(Pose pose, const Eigen::Vector3d& centre) {
  pose.translation() = pose * centre;
  return to_bullet(pose);
}

/// Returns Bullet's motion; nothing if Bullet would go another path.
std::optional<BulletMotion> motion_of(const Pose& pose, const std::optional<RigidCourse>& course,
                                      const Eigen::Vector3d& centre) {
  const RigidMotion motion = course ? RigidMotion(pose, *course) : RigidMotion(pose);
  if (std::abs(motion.angle()) >= kMostTurnedByBullet) return std::nullopt;
  const Eigen::Vector3d arm = pose * centre - motion.centre();
  if (motion.angle() != 0 && arm.cross(motion.axis()).norm() > kBesideTheAxis * arm.norm())
    return std::nullopt;
  return BulletMotion{bullet_pose(pose, centre), bullet_pose(motion.at(1), centre),
                      motion.angle() != 0};
}

/// Holds what a cast found: the time of a contact, or none. A pair that Bullet does not know has no
/// BulletFinding.
struct BulletFinding {
  std::optional<double> contact;
};

BulletFinding finding_of(btConvexCast& cast, const BulletMotion& a, const BulletMotion& b) {
  btConvexCast::CastResult result;
  result.m_fraction = 1;
  if (!cast.calcTimeOfImpact(a.from, a.to, b.from, b.to, result)) return {};
  return {result.m_fraction};
}

std::optional<BulletFinding> cast_convex(BulletCast how, const btConvexShape& shape_a,
                                         const BulletMotion& a, const btConvexShape& shape_b,
                                         const BulletMotion& b) {
  btVoronoiSimplexSolver simplex;
  if (how == BulletCast::Continuous) {
    btGjkEpaPenetrationDepthSolver depth;
    btContinuousConvexCollision cast(&shape_a, &shape_b, &simplex, &depth);
    return finding_of(cast, a, b);
  }
  if (a.turns || b.turns) return std::nullopt;
  if (how == BulletCast::Subsimplex) {
    btSubsimplexConvexCast cast(&shape_a, &shape_b, &simplex);
    return finding_of(cast, a, b);
  }
  btGjkConvexCast cast(&shape_a, &shape_b, &simplex);
  return finding_of(cast, a, b);
}

/// Casts at Bullet's mesh, which rests: the other goes as seen from the mesh.
std::optional<BulletFinding> cast_at_mesh(const btConvexShape& shape, const BulletMotion& moving,
                                          btBvhTriangleMeshShape& mesh,
                                          const BulletMotion& of_mesh) {
  if (of_mesh.turns) return std::nullopt;
  btTransform to = moving.to;
  to.setOrigin(to.getOrigin() - (of_mesh.to.getOrigin() - of_mesh.from.getOrigin()));
  btCollisionObject object;
  object.setCollisionShape(&mesh);
  object.setWorldTransform(of_mesh.from);
  btCollisionWorld::ClosestConvexResultCallback nearest(moving.from.getOrigin(), to.getOrigin());
  btCollisionWorld::objectQuerySingle(&shape, moving.from, to, &object, &mesh, of_mesh.from,
                                      nearest, 0);
  BulletFinding finding;
  if (nearest.hasHit()) finding.contact = nearest.m_closestHitFraction;
  return finding;
}

}  // namespace

BulletCasts::BulletCasts(std::span<const Shape> shapes, BulletCast how)
    : shapes_(shapes.begin(), shapes.end()), how_(how) {}
BulletCasts::~BulletCasts() = default;

std::optional<CaseAnswer> BulletCasts::answer(const Question& question, const PlacedShape& a,
                                              const PlacedShape& b) const {
  if (!cases::is_about_motion(question.ask) || question.settings.clearance != 0)
    return std::nullopt;
  bodies_.resize(shapes_.size());
  for (const std::size_t shape : {a.shape, b.shape}) {
    if (!bodies_[shape]) bodies_[shape] = std::make_unique<Body>(shapes_[shape]);
  }
  const Body &one = *bodies_[a.shape], &two = *bodies_[b.shape];
  const std::optional<BulletMotion> motion_a = motion_of(a.pose, question.course_a, one.centre());
  const std::optional<BulletMotion> motion_b = motion_of(b.pose, question.course_b, two.centre());
  if (!motion_a || !motion_b) return std::nullopt;
  const bool is_first = how_ == BulletCast::Continuous;
  std::optional<BulletFinding> found;
  if (one.convex() && two.convex()) {
    found = cast_convex(how_, *one.convex(), *motion_a, *two.convex(), *motion_b);
  } else if (is_first && one.convex() && two.half_space()) {
    btContinuousConvexCollision cast(one.convex(), two.half_space());
    found = finding_of(cast, *motion_a, *motion_b);
  } else if (is_first && one.half_space() && two.convex()) {
    btContinuousConvexCollision cast(two.convex(), one.half_space());
    found = finding_of(cast, *motion_b, *motion_a);
  } else if (is_first && one.convex() && two.mesh()) {
    found = cast_at_mesh(*one.convex(), *motion_a, *two.mesh(), *motion_b);
  } else if (is_first && one.mesh() && two.convex()) {
    found = cast_at_mesh(*two.convex(), *motion_b, *one.mesh(), *motion_a);
  }
  if (!found) return std::nullopt;
  return answer_of_motion(question.ask, found->contact);
}

}  // namespace graze::compare
