#pragma once

#include <vector>

#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Returns planks on two tables, one and three on each other, and a plank that lies on one table
/// alone and reaches out over its edge, with its middle inside. All must rest.
std::vector<Scene> planks(Surface surface, Extent extent);

/// Returns the same plank with its middle beyond the edge, by so many metres: it must tip and fall.
Scene tipping_plank(Surface surface, double beyond = 0.1);

}  // namespace graze::samples
