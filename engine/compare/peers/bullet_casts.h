#pragma once

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/world/shape.h>

#include <memory>
#include <span>

namespace graze::compare {

/// Which of Bullet's casts.
enum class BulletCast {
  Continuous,  ///< btContinuousConvexCollision, and its cast of a convex shape at a mesh
  Subsimplex,  ///< btSubsimplexConvexCast
  Gjk          ///< btGjkConvexCast
};

/// Shapes as Bullet holds them for questions about motions. What it needs is built for the first
/// such question. One thread at a time may ask.
class BulletCasts {
 public:
  BulletCasts(std::span<const Shape> shapes, BulletCast how);
  ~BulletCasts();
  BulletCasts(const BulletCasts&) = delete;
  BulletCasts& operator=(const BulletCasts&) = delete;

  /// Of Ask::FirstContact and Free, without a clearance: of two convex shapes, of one and a
  /// half-space, and of one and a mesh that does not turn. Nothing where a body turns by an eighth
  /// of a turn or more, at which Bullet stops it, or about a point other than its origin; nor
  /// where one turns, but by the first of the casts.
  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const;

 private:
  class Body;
  std::vector<Shape> shapes_;
  mutable std::vector<std::unique_ptr<Body>> bodies_;
  BulletCast how_;
};

}  // namespace graze::compare
