#pragma once

#include <optional>
#include <string>

namespace graze::cli {

/// Holds the arguments of `graze pair` as they are given.
struct PairOptions {
  std::string mesh_a;
  std::string mesh_b;
  std::string pose_a;
  std::string pose_b;
  std::optional<std::string> poses;  ///< empty is an error if it was given
  std::string query = "pairs";
  std::string volume = "wide";
  std::string touch = "include";
  std::string check;
  std::optional<std::string> output;  ///< empty is an error if it was given
  std::string threads;
  bool is_solid = false;
  bool is_listing = false;
  bool is_json = false;
  bool has_progress = false;
};

}  // namespace graze::cli
