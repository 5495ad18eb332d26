#pragma once

#include <vector>

#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Returns stacks and pyramids of one kind of body each, and stacks of all kinds, that must stand:
/// boxes, hulls and cylinders on each other; cylinders and capsules that lie between walls; cones,
/// balls and ellipsoids alone or on top. Bodies begin where they touch.
std::vector<Scene> stacks(Surface surface, Extent extent);

}  // namespace graze::samples
