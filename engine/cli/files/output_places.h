#pragma once

#include <functional>
#include <span>
#include <string>

namespace graze::cli {

/// A file that an option names.
struct FilePlace {
  std::string name;  ///< "--save", "the file of --poses"
  std::string path;  ///< empty: not given
};

/// Refuses what would be found out only after the work is done, or destroy what is read: throws
/// FileError for a file that cannot be written, and UsageError for one that is an input, that lies
/// among the cases of an input folder, that two options name, or that standard output goes to.
/// Pipes and devices may be named twice. Opens and creates nothing.
void check_outputs(std::span<const FilePlace> outputs, std::span<const FilePlace> inputs);

/// For the parser of options: an empty name is no file, and not the same as none.
std::function<std::string(const std::string&)> file_name();

}  // namespace graze::cli
