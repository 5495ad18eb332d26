#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <span>
#include <string>
#include <vector>

namespace graze::samples {

/// How a list of poses reads: pose i stands at `first + i * step`, in the unit that `column` names.
struct PoseTable {
  std::string title;
  std::string column;
  double first;
  double step;
  std::size_t rows_apart;  ///< print and time every so many poses; all of them are answered
};

/// Whether B in each of the poses intersects A. Prints a row, with the times of graze and of FCL,
/// if built with it, for every `rows_apart` poses.
std::vector<bool> answer_poses(const Mesh& mesh_a, const Mesh& mesh_b, std::span<const Pose> poses,
                               const PoseTable& table);

/// The index of the first pose that intersects; the number of poses if all are clear.
std::size_t first_hit(const std::vector<bool>& is_hit);

}  // namespace graze::samples
