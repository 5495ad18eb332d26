#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <graze/bvh/pose.h>

namespace graze::cli {

/// How many numbers a pose has: the rows of [R | t], one after the other, t in metres.
inline constexpr std::size_t kPoseNumbers = 12;

/// A pose and the line of the file that it comes from, counted from 1.
struct PoseLine {
  Pose pose;
  std::size_t line;
};

/// Reads 12 numbers separated by blanks or commas. Throws UsageError or PoseError, which begins
/// with `place`, for another count, for what is not a finite number and for a pose that is not
/// rigid.
Pose parse_pose(std::string_view text, const std::string& place);

/// Reads one pose per line; blank lines are skipped. Throws as parse_pose() does, naming
/// `file:line`, and for a file that cannot be read or holds no poses.
std::vector<PoseLine> load_poses(const std::filesystem::path& path);

}  // namespace graze::cli
