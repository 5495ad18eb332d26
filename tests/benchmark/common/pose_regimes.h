#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze::benchmark {

/// How far from touching two meshes are.
enum class Regime {
  Far,    ///< apart by more than the size of both
  Near,   ///< a gap of 0.1, 1 or 5 per cent of the size, pose by pose in turn
  Touch,  ///< 0.1 to 1 per cent in
  Deep,   ///< 10 to 40 per cent in
};
inline constexpr std::array kRegimes{Regime::Far, Regime::Near, Regime::Touch, Regime::Deep};

const char* name_of(Regime regime);

struct PoseSettings {
  std::size_t count = 60;
  std::uint64_t seed = 1;
};

/// Poses of B beside A in its own frame: B is turned at random and comes along a random direction
/// towards the centre of A until the surfaces touch, which is found by bisection. From there it is
/// moved back or on by the share of its size that the regime says. The size is half the diagonal of
/// the smaller bounds. Directions from which nothing is hit are drawn again. Throws InputError if
/// that happens a hundred times in a row.
std::vector<Pose> poses_in(Regime regime, const Mesh& mesh_a, const Mesh& mesh_b,
                           const PoseSettings& settings);

}  // namespace graze::benchmark
