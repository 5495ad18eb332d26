#pragma once

// Private to engine/mesh/rigid.

#include <graze/engine/mesh/rigid/moving_pair.h>

namespace graze {

/// Finds the axis along which two boxes are furthest apart. False if none has them further apart
/// than so many metres.
bool find_direction(const PlacedBodies& placed, const BodyBox& a, const BodyBox& b, double limit,
                    ApartDirection& direction);

}  // namespace graze
