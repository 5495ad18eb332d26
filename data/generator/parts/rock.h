#pragma once

#include "data/generator/surface.h"

namespace graze::generator {

/// A boulder: a sphere that blows have flattened in places and weather has roughened, the longest
/// side of its bounds 0.3 m. Every ray from the origin leaves it once, so it cannot cross itself.
Surface make_rock();

}  // namespace graze::generator
