#pragma once

#include <vector>

#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Returns a card house of two storeys and an arch of wedges without mortar. Both balance on
/// friction and on small areas, so that they show more of the solver than of the contacts: nothing
/// is asked of them.
std::vector<Scene> balances(Surface surface);

}  // namespace graze::samples
