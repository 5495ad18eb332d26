#pragma once

#include <graze/narrowphase/triangle.h>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// Two triangles, and how far the second one goes.
struct CastQuery {
  Triangle a;
  Triangle b;
  Eigen::Vector3d displacement;
};

/// Kinds of random queries, hard ones among them.
inline constexpr int kCastKinds = 14;
/// The one of which all meet at the start.
inline constexpr int kTouchingCasts = 9;

/// The kind's name, for messages.
const char* name_of_cast_kind(int kind);

CastQuery random_cast(int kind, RandomSource& source);

}  // namespace graze::tests
