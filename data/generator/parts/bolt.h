#pragma once

#include "data/generator/surface.h"

namespace graze::generator {

/// A hexagon head screw ISO 4017 M8 x 20, 6g, in millimetres. The thread's axis is z, the head lies
/// below z = 0, the tip at z = 20. Right-handed; at angle 0 crests are centred on multiples of the
/// pitch.
Surface make_bolt();

}  // namespace graze::generator
