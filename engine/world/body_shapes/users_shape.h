#pragma once

// Shapes of a user's own. Private to engine/world.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/body.h>

namespace graze {

/// False for what share() makes.
bool is_users_shape(const BodyShape& shape);

/// What `question()`, which asks the shape, says: of a user's own computed in the user's
/// arithmetic.
template <typename Question>
auto ask_shape(bool is_users, const Question& question) {
  if (!is_users) return question();
  return bvh::in_users_arithmetic([&] { return question(); });
}

}  // namespace graze
