#pragma once

#include "data/generator/surface.h"

namespace graze::generator {

/// Hilly ground over the square from -5 to 5 in x and y: one height over every point, open at its
/// border. Metres.
Surface make_terrain();

}  // namespace graze::generator
