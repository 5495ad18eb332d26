#pragma once

#include <vector>

#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Returns stairs, one body as a mesh or one slab a step, and on each step a body of another kind:
/// a box, a drum, a cylinder that stands, one that lies along the step against the riser. A plank
/// lies on the edges of all steps, held by friction.
std::vector<Scene> stairs(Surface surface, Extent extent);

}  // namespace graze::samples
