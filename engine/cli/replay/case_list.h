#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <graze/bvh/error.h>
#include <graze/engine/cases/read_case.h>

namespace graze::cli {

/// Holds a case that was read.
struct ListedCase {
  std::string name;                 ///< "odd.json", or of a file of many "odd.jsonl:7"
  std::filesystem::path file = {};  ///< the file of this case alone; empty if it is one of many
  Case query;
};

/// Returns the files that the arguments mean, folders in the order of their names: cases, .json, or
/// many of them, .jsonl, one on each line. Throws CaseError for a folder without any.
std::vector<std::filesystem::path> case_files(const std::vector<std::string>& arguments);

/// Reads a file of one case or of many. `on_case` gets each case, `on_refusal` the error of each
/// that cannot be read, whose what() names file and line; the others are read all the same. Meshes
/// by file lie beside the file unless the settings say otherwise.
void read_listed_cases(const std::filesystem::path& file, const ReadCaseSettings& settings,
                       const std::function<void(ListedCase)>& on_case,
                       const std::function<void(const Error&)>& on_refusal);

}  // namespace graze::cli
