#pragma once

#include <graze/bvh/sphere.h>
#include <graze/narrowphase/triangle.h>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// A triangle, a ball, and how far that goes.
struct BallQuery {
  Triangle triangle;
  Sphere ball;
  Eigen::Vector3d displacement;
};

/// Kinds of random queries: those of random_casts.h, with a ball in place of a triangle, and more.
inline constexpr int kBallKinds = 20;
/// The first of those that take a rational oracle long.
inline constexpr int kFirstLongBallKind = 17;

/// The kind's name, for messages.
const char* name_of_ball_kind(int kind);

BallQuery random_ball_query(int kind, RandomSource& source);

}  // namespace graze::tests
