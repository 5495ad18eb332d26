#pragma once

// Decides about spheres, a SIMD width at a time, what rounded arithmetic can. Callers hand over
// plain arrays: rows of doubles, in the order x, y, z, radius for spheres and min x, y, z, max x,
// y, z for boxes.

#include <array>
#include <cstddef>
#include <cstdint>

namespace graze::narrowphase {

using SphereRows = std::array<const double*, 4>;
using BoxRows = std::array<const double*, 6>;

// The verdicts that a kernel writes for a pair. An element that no test may be asked about is
// unsure.
inline constexpr std::uint8_t kSureApart = 0;
inline constexpr std::uint8_t kSureTouching = 1;
inline constexpr std::uint8_t kUnsure = 2;

/// Asks the rounded stage of decide() for `count` pairs, with the same bound. Where one volume
/// meets many, its rows have one element. The verdicts are the same on every SIMD target.
void judge_one_sphere(const SphereRows& one, const SphereRows& many, std::size_t count,
                      std::uint8_t* verdicts);
void judge_sphere_pairs(const SphereRows& a, const SphereRows& b, std::size_t count,
                        std::uint8_t* verdicts);
void judge_sphere_and_boxes(const SphereRows& one, const BoxRows& many, std::size_t count,
                            std::uint8_t* verdicts);
void judge_box_and_spheres(const BoxRows& one, const SphereRows& many, std::size_t count,
                           std::uint8_t* verdicts);
void judge_sphere_box_pairs(const SphereRows& spheres, const BoxRows& boxes, std::size_t count,
                            std::uint8_t* verdicts);

}  // namespace graze::narrowphase
