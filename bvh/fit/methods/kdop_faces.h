#pragma once

#include <graze/bvh/kdop.h>
#include <array>

namespace graze::bvh {

/// One of the 18 faces, in the units of KDopFaces.
struct KDopFace {
  double area;      ///< 0 where the slab is looser than the polytope
  double distance;  ///< how far its plane is from the middle of the coordinate slabs, outward
};

struct KDopFaces {
  double unit;  ///< metres for each unit of distance
  std::array<KDopFace, 18> faces;
};

/// Returns the faces of a valid k-DOP: the plane of each bound, clipped by the other slabs.
KDopFaces faces_of(const KDop<18>& kdop);

}  // namespace graze::bvh
