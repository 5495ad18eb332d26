#pragma once

#include <functional>
#include <span>
#include <string>

namespace graze::cli {

/// Names a file that an option names.
struct FilePlace {
  std::string name;  ///< "--save", "the file of --poses"
  std::string path;  ///< empty if the option was not given
};

/// Refuses outputs that would fail only after the work is done, or destroy what is read. Throws
/// FileError for a file that cannot be written, and UsageError for one that is an input, that lies
/// among the cases of an input folder, that two options name, or that standard output goes to.
/// Pipes and devices may be named twice. It opens and creates nothing.
void check_outputs(std::span<const FilePlace> outputs, std::span<const FilePlace> inputs);

/// Checks names for the parser of options: an empty name is no file, and not the same as no name.
std::function<std::string(const std::string&)> file_name();

}  // namespace graze::cli
