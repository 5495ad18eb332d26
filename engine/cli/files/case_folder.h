#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include <graze/engine/cases/case.h>

namespace graze::cli {

/// Returns a word for the name of a file, made of any text: letters, digits and `_+.` stay, all
/// else is `_`, and it ends after 40 characters.
std::string name_part(std::string_view text);

/// Returns `NAME-CLASS-DIGEST.json`. The digest is of the question, bit for bit, and of the engine
/// and its version: other questions have other names, and the same one has the same in every run.
std::string case_file_name(const std::string& name, const std::string& error_class,
                           const Case& question);

/// Writes the cases of a run into a folder. It removes nothing, and replaces only cases of the same
/// name.
class CaseFolder {
 public:
  explicit CaseFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path path(const std::string& file) const { return folder_ / file; }

  /// Makes the folder if need be. False, with a reason, if that or the writing fails.
  bool write(const std::string& file, const Case& query);

  /// Says why the first case could not be written, naming the place; empty if all could.
  const std::string& failure() const { return failure_; }

  /// Returns how many cases lie there that this run has not written.
  std::size_t count_others() const;

 private:
  std::filesystem::path folder_;
  std::string failure_;
  std::set<std::string> written_;
};

}  // namespace graze::cli
