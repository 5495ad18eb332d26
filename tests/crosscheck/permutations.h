#pragma once

#include <array>

#include <graze/narrowphase/triangle.h>

namespace graze::crosscheck {

/// The six triangles that are one closed triangle (law 4), the given order first.
inline std::array<Triangle, 6> permutations(const Triangle& t) {
  const auto& [a, b, c] = t;
  return {Triangle{a, b, c}, {b, c, a}, {c, a, b}, {c, b, a}, {b, a, c}, {a, c, b}};
}

}  // namespace graze::crosscheck
