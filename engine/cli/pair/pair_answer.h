#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include <graze/engine/compare/compare.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/work.h>

namespace graze::cli {

/// Says what `graze pair` was asked for each pose.
enum class PairQuery { Any, Pairs, Distance };

/// Holds what it found for one pose.
struct PoseAnswer {
  std::size_t pose = 0;  ///< the pose's number, counted from 0
  bool intersects = false;
  std::optional<TrianglePairs> pairs;  ///< the pairs, if the query was for them
  std::optional<MeshDistance> gap;     ///< the distance, if the query was for it
  Work work;
  std::chrono::duration<double, std::micro> time{0};
  std::optional<compare::Comparison> fcl;  ///< the comparison with FCL, if a check was asked for
};

}  // namespace graze::cli
