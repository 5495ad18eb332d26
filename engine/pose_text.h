#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <graze/bvh/pose.h>

namespace graze {

/// The number of numbers that a pose has as text: the rows of [R | t], one after the other, t in
/// metres.
inline constexpr std::size_t kPoseNumbers = 12;

/// A pose and the line of the file that it stands on, counted from 1.
struct PoseLine {
  Pose pose;         ///< rigid
  std::size_t line;  ///< counted from 1
};

/// Reads 12 numbers separated by blanks or commas, each rounded once to double. Throws PoseError,
/// which begins with `place`, for another count, for what is not a finite number and for a pose
/// that is not rigid.
Pose parse_pose(std::string_view text, const std::string& place);

/// Reads one pose per line; blank lines are skipped. The file may also be an array that numpy has
/// saved (.npy, told by its first bytes): float64 in C order of the shape (n, 3, 4) or (n, 4, 4),
/// whose poses are counted from 1 in place of lines. Throws PoseError as parse_pose() does, naming
/// `file:line`, and for a file that cannot be read or holds no poses. The time is linear; an array
/// takes its size in memory.
std::vector<PoseLine> load_pose_lines(const std::filesystem::path& path);

/// Returns the poses of load_pose_lines() without their lines. Throws as it does.
std::vector<Pose> load_poses(const std::filesystem::path& path);

}  // namespace graze
