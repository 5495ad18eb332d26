#pragma once

#include <array>
#include <cstddef>

namespace graze {

/// The directions of the slabs of a k-DOP, K / 2 of them, not normalised. They are small integers,
/// so that a coordinate along one is a sum of few coordinates.
template <int K>
inline constexpr std::array<std::array<int, 3>, static_cast<std::size_t>(K / 2)> kKDopDirections{};

/// The normals of a box's faces and bevelled edges, which are what Klosowski and others found to
/// serve best ("Efficient collision detection using bounding volume hierarchies of k-DOPs", 1998).
template <>
inline constexpr std::array<std::array<int, 3>, 9> kKDopDirections<18>{{{1, 0, 0},
                                                                        {0, 1, 0},
                                                                        {0, 0, 1},
                                                                        {1, 1, 0},
                                                                        {1, 0, 1},
                                                                        {0, 1, 1},
                                                                        {1, -1, 0},
                                                                        {1, 0, -1},
                                                                        {0, 1, -1}}};

/// A closed discrete oriented polytope: the points p with min[i] <= p . kKDopDirections<K>[i] <=
/// max[i] for each of the K / 2 slabs, metres. `min <= max` holds for each slab; a slab may be
/// looser than the polytope. Only K = 18 has directions.
template <int K>
struct KDop {
  static constexpr int kSlabs = K / 2;                       ///< the number of slabs
  std::array<double, static_cast<std::size_t>(kSlabs)> min;  ///< the lower bound of each slab,
                                                             ///< along its direction
  std::array<double, static_cast<std::size_t>(kSlabs)> max;  ///< the upper bound of each slab,
                                                             ///< along its direction

  bool operator==(const KDop&) const = default;
};

/// Throws InputError, which begins with `what`, unless all slabs are finite and `min <= max`.
void check_kdop(const KDop<18>& kdop, const char* what);

}  // namespace graze
