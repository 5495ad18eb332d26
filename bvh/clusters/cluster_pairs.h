#pragma once

#include <graze/bvh/clusters/clusters.h>

#include <cstdint>

namespace graze::bvh {

/// Bit 8 i + j of each speaks of lane i of one cluster and lane j of another: whether their boxes
/// overlap, and whether they share a label besides.
struct ClusterPairs {
  std::uint64_t overlapping = 0;
  std::uint64_t sharing = 0;
};

/// Two clusters in one frame. Exact, and the same on every SIMD target.
ClusterPairs pairs_of(const Cluster& a, const Cluster& b);

/// One cluster with itself: each pair once, at the lower of its lanes.
ClusterPairs pairs_within(const Cluster& cluster);

}  // namespace graze::bvh
