#pragma once

#include <cstdint>
#include <cstring>

namespace graze::bvh {

/// Two doubles in a register, as Lanes are four floats.
using Pair = double __attribute__((vector_size(16)));
using PairMask = std::int64_t __attribute__((vector_size(16)));

static inline Pair smaller(Pair a, Pair b) {
  return a < b ? a : b;
}

static inline Pair larger(Pair a, Pair b) {
  return a > b ? a : b;
}

/// Three coordinates, of which y is there twice, so that they are loaded as they lie in memory.
struct PointPairs {
  Pair xy;
  Pair yz;
};

static inline PointPairs load_point(const double* coordinates) {
  PointPairs p;
  std::memcpy(&p.xy, coordinates, sizeof(Pair));
  std::memcpy(&p.yz, coordinates + 1, sizeof(Pair));
  return p;
}

static inline PointPairs smaller(const PointPairs& a, const PointPairs& b) {
  return {smaller(a.xy, b.xy), smaller(a.yz, b.yz)};
}

static inline PointPairs larger(const PointPairs& a, const PointPairs& b) {
  return {larger(a.xy, b.xy), larger(a.yz, b.yz)};
}

}  // namespace graze::bvh
