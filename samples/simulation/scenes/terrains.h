#pragma once

#include <filesystem>

#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Returns boxes, drums, cylinders and capsules that fall from 0.3 m onto the bundled terrain, on a
/// grid: 36, or 400 if it is large. `data` is the folder of the bundled data.
Scene terrain(Surface surface, Extent extent, const std::filesystem::path& data);

}  // namespace graze::samples
