#pragma once

#include <cstdint>
#include <span>

#include "tests/benchmark/error/elements.h"

// What the pages of the library's own contestants share.

namespace graze::benchmark {

inline Label exact(const char* name) {
  return {name, Origin::Graze, "exact", std::nullopt};
}

/// The batch functions answer with bytes, which an Answer is; 1 is Touching.
inline std::span<std::uint8_t> as_hits(std::span<Answer> answers) {
  static_assert(static_cast<std::uint8_t>(Answer::Touching) == 1);
  return {reinterpret_cast<std::uint8_t*>(answers.data()), answers.size()};
}

/// Its tests of spheres: part of add_graze().
void add_graze_spheres(Field& field);

/// Likewise of oriented boxes and k-DOPs, of which only "apart" is sure.
void add_graze_volumes(Field& field);

/// Likewise of features on straight paths.
void add_graze_motions(Field& field);

/// Likewise its distances, of triangles and of meshes.
void add_graze_distances(Field& field);

}  // namespace graze::benchmark
