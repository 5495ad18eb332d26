#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/line_file.h>

namespace graze::compare {

/// One of the things that a comparison is about.
struct JournalPart {
  std::string name;   ///< "question", "mesh A"
  std::string value;  ///< for people, or a SHA-256
};

/// What tells one comparison from another: the first line of its file.
struct JournalHead {
  std::string kind;                ///< the first key of the file: "graze_comparison"
  std::string unit;                ///< of what the other lines are, one each: "poses"
  std::string key;                 ///< SHA-256 of all that is asked
  std::vector<JournalPart> parts;  ///< the same one by one, to say what differs
  std::size_t places = 0;          ///< how many lines a complete one has
};

/// The first line, as far as it says more than the job does.
struct JournalStart {
  bool is_same_job = false;
  std::string difference;            ///< of another job, for people: what is other than it is here
  std::vector<std::string> engines;  ///< that were asked
};

/// A comparison in a file, a line a place behind a line that names the job: what a run that was
/// stopped is resumed from, and what a later run is held against.
template <typename Record>
struct Journal {
  JournalStart start;
  std::vector<Record> records;  ///< of this job, in the order of the file, each place once
};

/// Calls `on_record` with each line behind the first, if that is of this job. Throws CaseError,
/// naming file and line, and for a file that is no record of a comparison. A last line that a
/// stopped run left unfinished is dropped: its place is asked again.
JournalStart read_journal_lines(const std::filesystem::path& path, const JournalHead& head,
                                const std::function<void(const cases::JsonCursor&)>& on_record);

/// Reads the records of a job. Throws CaseError for a place that stands twice.
template <typename Record>
Journal<Record> read_journal(const std::filesystem::path& path, const JournalHead& head,
                             const std::function<Record(const cases::JsonCursor&)>& read) {
  Journal<Record> journal;
  std::set<std::size_t> seen;
  journal.start = read_journal_lines(path, head, [&](const cases::JsonCursor& line) {
    Record record = read(line);
    if (!seen.insert(record.place).second) {
      line.fail("number " + std::to_string(record.place) + " stands twice");
    }
    journal.records.push_back(std::move(record));
  });
  return journal;
}

/// The file of a job with these records as lines, to which more can be added as they come.
LineFile start_journal(const std::filesystem::path& path, const JournalHead& head,
                       std::span<const EngineEntry> engines, std::span<const std::string> records);

}  // namespace graze::compare
