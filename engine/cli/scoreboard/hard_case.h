#pragma once

#include <string>

#include <graze/engine/cli/output/output.h>

namespace graze::cli {

/// Describes a case that is to join a folder of hard cases.
struct HardCaseOptions {
  std::string folder;  ///< a folder of files .jsonl, one for each class, with a README.md that
                       ///< counts them
  std::string file;    ///< the file of the case
  std::string kind;    ///< the case's class: the name of a file without its end
  std::string origin;  ///< where it is from, for people; if it is empty, the case says it
  std::string note;    ///< what is hard about it; if it is empty, the case says it
};

/// Writes the case as a line of the class's file, in plain numbers, with the truth for its answer:
/// the recorded one if the referee finds it right, else graze's if it finds that right. Then the
/// counts in the table of README.md are those of the folder's files. Throws UsageError for a case
/// without an origin or a note, for one that is there, of the same note or the same question, and
/// where neither answer is proved; CaseError for an invalid case; FileError.
void add_hard_case(const HardCaseOptions& options, Output& output);

/// Returns a page whose table has rows "| `NAME.jsonl` | COUNT | ..." with these counts: the lines
/// of the files of the folder. Rows without a file are left as they are.
std::string with_counts(const std::string& page, const std::string& folder);

}  // namespace graze::cli
