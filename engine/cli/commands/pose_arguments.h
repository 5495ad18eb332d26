#pragma once

#include <string>
#include <vector>

namespace graze::cli {

/// Rewrites `--pose-a` and `--pose-b` with the arguments that follow, be it one with 12 numbers or
/// 12 with one each, as a single argument `--pose-a=...`: a parser of options then cannot take
/// negative numbers for options, nor meshes for numbers.
std::vector<std::string> join_pose_arguments(const std::vector<std::string>& arguments);

}  // namespace graze::cli
