#pragma once

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/world/shape.h>

#include <memory>
#include <span>

namespace graze::compare {

/// Names Bullet's casts.
enum class BulletCast {
  Continuous,  ///< btContinuousConvexCollision, and its cast of a convex shape at a mesh
  Subsimplex,  ///< btSubsimplexConvexCast
  Gjk          ///< btGjkConvexCast
};

/// Holds shapes as Bullet does for questions about motions. What Bullet needs is built for the
/// first such question. One thread may ask at a time.
class BulletCasts {
 public:
  BulletCasts(std::span<const Shape> shapes, BulletCast how);
  ~BulletCasts();
  BulletCasts(const BulletCasts&) = delete;
  BulletCasts& operator=(const BulletCasts&) = delete;

  /// Answers Ask::FirstContact and Free, without a clearance: about two convex shapes, one and a
  /// half-space, and one and a mesh that does not turn. Returns nothing where a body turns by an
  /// eighth of a turn or more, at which Bullet stops it, or about a point other than its origin;
  /// nor, but for the first of the casts, where one turns at all.
  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const;

 private:
  class Body;
  std::vector<Shape> shapes_;
  mutable std::vector<std::unique_ptr<Body>> bodies_;
  BulletCast how_;
};

}  // namespace graze::compare
