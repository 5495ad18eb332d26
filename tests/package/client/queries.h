#pragma once

#include <cstdint>

namespace client {

/// What a fixed set of queries answered: how many, how many of them yes, and a digest of it all.
struct Answers {
  std::uint64_t queries = 0;
  std::uint64_t hits = 0;
  std::uint64_t digest = 0;
};

/// Where the library puts points: law 1, bit for bit.
Answers place_points();

/// Triangles against triangles, boxes and oriented boxes: at random, on lattices where most touch,
/// turned and moved by ulps, degenerate, huge, tiny and denormal.
Answers test_triangles();

/// Meshes made here against each other, against boxes and against themselves, in poses where they
/// nearly touch.
Answers query_meshes();

/// Meshes, volumes, boxes that move and batches whose coordinates are all denormal, by one thread
/// and by all.
Answers query_denormal();

/// Values that must be refused are refused: what was thrown for each.
Answers offer_bad_values();

}  // namespace client
