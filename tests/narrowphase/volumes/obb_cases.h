#pragma once

#include <graze/bvh/obb.h>

#include <cstddef>

#include "tests/shapes/random_source.h"

namespace graze {

/// How two oriented boxes lie to each other.
enum class Lie {
  Any,
  Faces,           // of one orientation, moved apart along an axis
  Edges,           // moved apart along the product of two edges
  ParallelEdges,   // turned about a common axis
  NearlyParallel,  // likewise, and a little more, of any size
  Flat,            // some half extents are 0
  Points,          // all those of one or both
  FarFromOrigin,   // about 1e9 away from it
  Scaled,          // by 1e-150 to 1e150
  UnequalSizes,    // one up to 1e9 times as large
  Lattice,         // axes and sizes of small integers
  NotQuiteRigid    // poses deviate from rotations by up to 1e-6
};

inline constexpr Lie kEveryLie[] = {Lie::Any,           Lie::Faces,          Lie::Edges,
                                    Lie::ParallelEdges, Lie::NearlyParallel, Lie::Flat,
                                    Lie::Points,        Lie::Scaled,         Lie::UnequalSizes,
                                    Lie::FarFromOrigin, Lie::Lattice,        Lie::NotQuiteRigid};
inline constexpr std::size_t kLies = sizeof(kEveryLie) / sizeof(kEveryLie[0]);

const char* name_of(Lie lie);

/// Two boxes, and a way to move B by which they come apart.
struct ObbCase {
  Obb a;
  Obb b;
  Eigen::Vector3d way;

  /// B with its centre at that of A + distance * way, rounded.
  Obb b_at(double distance) const;

  /// The sum of all half extents.
  double size() const;
};

ObbCase random_case(Lie lie, RandomSource& random);

Eigen::Matrix3d random_rotation(RandomSource& random);

/// Two adjacent distances (or as good as adjacent), at the smaller of which `is_hit` holds, and at
/// the larger not.
struct Border {
  double hit;
  double apart;
};

template <typename IsHit>
Border find_border(double hit, double apart, const IsHit& is_hit) {
  for (int step = 0; step < 120; ++step) {
    const double middle = hit + 0.5 * (apart - hit);
    if (middle == hit || middle == apart) break;
    (is_hit(middle) ? hit : apart) = middle;
  }
  return {hit, apart};
}

}  // namespace graze
