#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include <graze/engine/compare/compare.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/work.h>

namespace graze::cli {

/// What `graze pair` was asked for each pose.
enum class PairQuery { Any, Pairs, Distance };

/// What it found for one pose.
struct PoseAnswer {
  std::size_t pose = 0;  ///< counted from 0
  bool intersects = false;
  std::optional<TrianglePairs> pairs;  ///< if the query was for pairs
  std::optional<MeshDistance> gap;     ///< if it was for the distance
  Work work;
  std::chrono::duration<double, std::micro> time{0};
  std::optional<compare::Comparison> fcl;  ///< if a check was asked for
};

}  // namespace graze::cli
