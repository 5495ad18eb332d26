#pragma once

#include <vector>

#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Planks on two tables, one and three on each other; a plank that lies on a table alone and
/// reaches out over its edge, with its middle inside. All must rest.
std::vector<Scene> planks(Surface surface, Extent extent);

/// The same plank with its middle beyond the edge, by so many metres: it must tip and fall.
Scene tipping_plank(Surface surface, double beyond = 0.1);

}  // namespace graze::samples
