#pragma once

// This finds where the corners of primitives lie along some directions, four primitives at a time.
// It is private to bvh/wide; functions are static for the reason given in float_box.h.

#include <graze/bvh/value/lanes.h>
#include <graze/bvh/wide/tree/corner_rows.h>
#include <graze/bvh/wide/tree/fit_node.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace graze::bvh {

struct Interval {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
};

/// Says where something lies along so many directions, from an origin.
template <std::size_t kDirections>
using Extent = std::array<Interval, kDirections>;

/// Directions and an origin in all lanes.
template <std::size_t kDirections>
struct Projection {
  Projection(const float (&directions)[kDirections][3], const float* from) {
    for (std::size_t k = 0; k < 3; ++k) {
      origin[k] = all_lanes(from[k]);
      for (std::size_t i = 0; i < kDirections; ++i)
        rows[i][k] = all_lanes(directions[i][k]);
    }
  }

  Lanes origin[3];
  Lanes rows[kDirections][3];
};

static inline Lanes lanes_at(const float* values) {
  Lanes lanes;
  std::memcpy(&lanes, values, sizeof(lanes));
  return lanes;
}

static inline float least(Lanes v) {
  return std::min(std::min(v[0], v[1]), std::min(v[2], v[3]));
}
static inline float greatest(Lanes v) {
  return std::max(std::max(v[0], v[1]), std::max(v[2], v[3]));
}

/// Returns the extent of consecutive primitives.
template <std::size_t kDirections>
static inline Extent<kDirections> extent_of(const CornerRows& rows,
                                            const Projection<kDirections>& onto,
                                            const PrimitiveRange& range) {
  const Interval nothing;
  Lanes low[kDirections], high[kDirections];
  for (std::size_t i = 0; i < kDirections; ++i) {
    low[i] = all_lanes(nothing.low);
    high[i] = all_lanes(nothing.high);
  }
  for (std::size_t first = range.begin; first < range.end; first += 4) {
    // Lanes behind the last primitive change nothing.
    const auto left = static_cast<std::int32_t>(range.end - first);
    const IntLanes is_there = IntLanes{0, 1, 2, 3} < IntLanes{left, left, left, left};
    for (std::size_t c = 0; c < 3; ++c) {
      const Lanes x = lanes_at(rows.row(c, 0) + first) - onto.origin[0];
      const Lanes y = lanes_at(rows.row(c, 1) + first) - onto.origin[1];
      const Lanes z = lanes_at(rows.row(c, 2) + first) - onto.origin[2];
      for (std::size_t i = 0; i < kDirections; ++i) {
        const Lanes* row = onto.rows[i];
        const Lanes along = (row[0] * x + row[1] * y) + row[2] * z;
        low[i] = smaller(low[i], chosen(is_there, along, low[i]));
        high[i] = larger(high[i], chosen(is_there, along, high[i]));
      }
    }
  }
  Extent<kDirections> extent;
  for (std::size_t i = 0; i < kDirections; ++i)
    extent[i] = {least(low[i]), greatest(high[i])};
  return extent;
}

}  // namespace graze::bvh
