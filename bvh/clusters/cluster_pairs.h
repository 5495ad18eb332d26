#pragma once

#include <graze/bvh/clusters/clusters.h>

#include <cstdint>

namespace graze::bvh {

/// The pairs of two clusters: bit 8 i + j of each number speaks of lane i of the one and lane j of
/// the other, whether their boxes overlap, and whether they share a label besides.
struct ClusterPairs {
  std::uint64_t overlapping = 0;
  std::uint64_t sharing = 0;
};

/// Returns the pairs of two clusters in one frame. They are exact, and the same on every SIMD
/// target.
ClusterPairs pairs_of(const Cluster& a, const Cluster& b);

/// Returns the pairs of one cluster with itself: each pair once, at the lower of its lanes.
ClusterPairs pairs_within(const Cluster& cluster);

}  // namespace graze::bvh
