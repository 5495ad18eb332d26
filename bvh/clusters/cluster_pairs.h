#pragma once

#include <graze/bvh/clusters/clusters.h>

#include <cstdint>

namespace graze::bvh {

/// Of lane i of one cluster, byte i: the bits of the lanes of another whose boxes overlap its own,
/// and of these, those that share a label with it.
struct ClusterPairs {
  std::uint8_t overlapping[Cluster::kWidth];
  std::uint8_t sharing[Cluster::kWidth];
};

/// Two clusters in one frame. Exact, and the same on every SIMD target.
ClusterPairs pairs_of(const Cluster& a, const Cluster& b);

/// One cluster with itself: each pair once, at the lower of its lanes.
ClusterPairs pairs_within(const Cluster& cluster);

}  // namespace graze::bvh
