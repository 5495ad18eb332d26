#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace graze::benchmark {

/// What queries cost with one volume, over all poses.
struct QueryMeasure {
  std::string volume;         ///< as the command line calls it; "sphere-obb" for a cascade
  double any_microseconds;    ///< median over the poses: do they intersect
  double pairs_microseconds;  ///< median over the poses: all pairs
  Work any;                   ///< sums over the poses
  Work pairs;
  std::size_t hits;  ///< pairs of triangles that intersect, over all poses

  /// Of the pairs of triangles that the volumes let through, the share that do not intersect.
  double false_share() const;
};

/// For each of kPairVolumes and each cascade; `on_pose()` is called after each pose. Volumes take
/// turns pose by pose, so that a slow moment of the machine hits all of them. Each time is the
/// median of `repetitions`. Throws Error if two volumes disagree.
std::vector<QueryMeasure> measure_queries(const Mesh& mesh_a, const Mesh& mesh_b,
                                          std::span<const Pose> poses, int repetitions,
                                          const std::function<void()>& on_pose);

}  // namespace graze::benchmark
