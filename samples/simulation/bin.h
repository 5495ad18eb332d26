#pragma once

#include <graze/engine/mesh/mesh.h>

namespace graze::samples {

/// Describes a bin with flat sides and thick walls, open at the top; lengths in metres.
struct BinSize {
  int sides = 8;
  double floor_radius = 0.048;  ///< the radius of the corners, inside
  double mouth_radius = 0.075;
  double height = 0.07;
  double thickness = 0.015;
  int halvings = 3;  ///< the number of times that its triangles' edges are halved: small triangles
                     ///< meet few of the bodies on them
};

/// Returns a closed mesh; the floor's upper side is at z = 0, the mouth at z = height.
Mesh make_bin(const BinSize& size);

/// Returns how far from the axis a point inside can be at that height.
double inner_radius(const BinSize& size, double z);

}  // namespace graze::samples
