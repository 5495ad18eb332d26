#pragma once

#include "data/generator/parts/involute.h"
#include "data/generator/surface.h"

namespace graze::generator {

/// How a gear is turned into a solid: face width and bore in millimetres, and how many layers of
/// triangles its face width is divided into.
struct GearBody {
  SpurGear gear;
  double width;
  double bore_radius;
  int layers;
};

/// The bundled pair: module 2 mm, 31 and 19 teeth, so that the nominal centre distance is 50 mm.
/// Each tooth is thinned by 0.04 mm: a backlash of 0.08 mm along the reference circle.
inline constexpr GearBody kGear{{31, 2, 0.04}, 12, 10, 3};
inline constexpr GearBody kPinion{{19, 2, 0.04}, 14, 6, 4};

/// A gear around the z axis, its middle plane z = 0, the middle of a tooth at angle 0. Millimetres.
Surface make_gear(const GearBody& body);

}  // namespace graze::generator
