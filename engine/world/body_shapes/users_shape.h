#pragma once

// Tells shapes of a user's own from those of the library. Private to engine/world.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/body.h>

namespace graze {

/// False for shapes that share() makes.
bool is_users_shape(const BodyShape& shape);

/// Returns `question()`, which asks the shape. For a user's own shape it is computed in the user's
/// arithmetic.
template <typename Question>
auto ask_shape(bool is_users, const Question& question) {
  if (!is_users) return question();
  return bvh::in_users_arithmetic([&] { return question(); });
}

}  // namespace graze
