#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/files/output_file.h>

namespace graze::compare {

/// Holds one of the things that a comparison is about.
struct JournalPart {
  std::string name;   ///< "question", "mesh A"
  std::string value;  ///< words for people, or a SHA-256
};

/// Names an engine that was asked, or whose answers were read.
struct JournalEngine {
  std::string name;
  std::string version;
  std::string answers = {};  ///< the SHA-256 of the file of its answers; empty if it was asked
                             ///< itself

  bool operator==(const JournalEngine&) const = default;
};

std::vector<JournalEngine> journal_engines(std::span<const EngineEntry> engines);

/// Names one run of a job that is cut into `count` of them, `number` counted from 1.
struct JobPart {
  std::size_t number = 1;
  std::size_t count = 1;

  bool is_whole() const { return count == 1; }
  /// Return the places of the part, [first, end) of all: every one is in one part, and the sizes of
  /// parts differ by at most 1.
  std::size_t first(std::size_t places) const;
  std::size_t end(std::size_t places) const;
  bool operator==(const JobPart&) const = default;
};

/// Tells one comparison from another: the first line of its file.
struct JournalHead {
  std::string kind;                ///< the first key of the file: "graze_comparison"
  std::string unit;                ///< what its places are: "poses"
  std::string key;                 ///< the SHA-256 of all that is asked
  std::vector<JournalPart> parts;  ///< all that is asked, part by part, to say what differs
  std::size_t places = 0;          ///< the places of the whole job
  JobPart part = {};               ///< the part of the job that this record has
  std::vector<JournalEngine> engines = {};

  std::size_t first() const { return part.first(places); }
  std::size_t end() const { return part.end(places); }
};

/// Returns the line, as it stands in a file, without its break.
std::string to_json(const JournalHead& head);

/// Returns in words how the job of a record is another one than that of `head`; empty if it is the
/// same job, and the same part of it. Its engines may be others.
std::string job_difference(const JournalHead& head, const JournalHead& record);

/// Returns in words how the engines of a record differ; empty if they are the same, in the same
/// order.
std::string engine_difference(const JournalHead& head, const JournalHead& record);

/// Returns the line with a sum of all of it at its end, by which a damaged line is known. `line` is
/// a JSON object of at least one member.
std::string sealed(std::string_view line);

/// Reads a comparison in a file, line by line: behind the head come the places, all in their order,
/// as many as there are so far. A last line without a break is what a run was writing when it was
/// stopped, and does not count.
class JournalReader {
 public:
  /// Reads the head. Throws CaseError, naming file and line, for any other file than a record of a
  /// comparison.
  explicit JournalReader(const std::filesystem::path& path);

  const JournalHead& head() const { return head_; }

  /// Reads the next line; false at the end. Throws CaseError for a line whose sum is another.
  bool next(std::string& line);

  /// Returns where the last line stands that was read: "run.jsonl:7".
  const std::string& place() const { return place_; }

  /// Returns how many bytes were read, all of whole lines.
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::size_t number_ = 0;
  std::uint64_t bytes_ = 0;
  std::string place_;
  JournalHead head_;
};

/// Writes the record of a run that may be stopped at any time, and goes on then: each line is
/// handed to the system as it is added. Nobody else may write it meanwhile. A pipe or a device is
/// written through.
class JournalFile {
 public:
  /// Opens the file, or makes it, for this process alone. Throws CaseError, also if another run is
  /// writing it.
  explicit JournalFile(const std::filesystem::path& path);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// True if there are whole lines of an earlier run.
  bool has_record(const JournalHead& head) const;

  /// Begins a record in the place of what was there.
  void begin(const JournalHead& head);
  /// Goes on behind so many bytes.
  void go_on(std::uint64_t bytes);
  void add(std::string_view line);

 private:
  void write(std::string_view bytes);
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;
  int descriptor_ = -1;                         ///< the descriptor of a regular file
  std::unique_ptr<files::OutputFile> through_;  ///< the way to anything else
};

}  // namespace graze::compare
