#pragma once

#include "data/generator/surface.h"

namespace graze::generator {

/// A hexagon nut ISO 4032 M8, 6H, in millimetres, from z = 0 to z = 6.8 around the z axis. Moved
/// along z by a multiple of the pitch it sits on the thread of make_bolt() with clearance all
/// around; a turn by an angle goes with an advance by pitch * angle / (2 pi).
Surface make_nut();

}  // namespace graze::generator
