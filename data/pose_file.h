#pragma once

#include <graze/bvh/pose.h>
#include <filesystem>
#include <vector>

namespace graze::data {

/// Reads poses, one per line: the twelve numbers of the rows of [R | t], metres. Throws
/// graze::Error with file and line for anything else, and for a file without poses.
std::vector<Pose> read_poses(const std::filesystem::path& path);

}  // namespace graze::data
