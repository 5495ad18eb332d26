#pragma once

#include <graze/bvh/kdop.h>
#include <array>

namespace graze::bvh {

/// One of the 18 faces, in the units of KDopFaces.
struct KDopFace {
  double area;      ///< 0 where the slab is looser than the polytope
  double distance;  ///< of its plane from the middle of the coordinate slabs, outward
};

struct KDopFaces {
  double unit;  ///< metres
  std::array<KDopFace, 18> faces;
};

/// The faces of a valid k-DOP: the plane of each bound, clipped by the other slabs.
KDopFaces faces_of(const KDop<18>& kdop);

}  // namespace graze::bvh
