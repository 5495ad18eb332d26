#pragma once

#include <graze/narrowphase/first_contact.h>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// A point and a triangle, and two edges, of the same four paths.
struct PathQuery {
  PointPath path[4];

  PointPath point() const { return path[0]; }
  TrianglePath triangle() const { return {path[1], path[2], path[3]}; }
  EdgePath edge_a() const { return {path[0], path[1]}; }
  EdgePath edge_b() const { return {path[2], path[3]}; }
};

/// Kinds of random paths, hard ones among them.
inline constexpr int kPathKinds = 14;

/// The kind's name, for messages.
const char* name_of_path_kind(int kind);

PathQuery random_paths(int kind, RandomSource& source);

}  // namespace graze::tests
