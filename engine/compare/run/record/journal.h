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

/// One of the things that a comparison is about.
struct JournalPart {
  std::string name;   ///< "question", "mesh A"
  std::string value;  ///< for people, or a SHA-256
};

/// An engine that was asked, or whose answers were read.
struct JournalEngine {
  std::string name;
  std::string version;
  std::string answers = {};  ///< the SHA-256 of the file of its answers; empty: it was asked itself

  bool operator==(const JournalEngine&) const = default;
};

std::vector<JournalEngine> journal_engines(std::span<const EngineEntry> engines);

/// One run of a job that is cut into `count` of them, `number` counted from 1.
struct JobPart {
  std::size_t number = 1;
  std::size_t count = 1;

  bool is_whole() const { return count == 1; }
  /// Its places are [first, end) of all: every one is in one part, and their sizes differ by 1.
  std::size_t first(std::size_t places) const;
  std::size_t end(std::size_t places) const;
  bool operator==(const JobPart&) const = default;
};

/// What tells one comparison from another: the first line of its file.
struct JournalHead {
  std::string kind;                ///< the first key of the file: "graze_comparison"
  std::string unit;                ///< of its places: "poses"
  std::string key;                 ///< SHA-256 of all that is asked
  std::vector<JournalPart> parts;  ///< the same one by one, to say what differs
  std::size_t places = 0;          ///< of the whole job
  JobPart part = {};               ///< of which this record has some
  std::vector<JournalEngine> engines = {};

  std::size_t first() const { return part.first(places); }
  std::size_t end() const { return part.end(places); }
};

/// The line, as it stands in a file, without its break.
std::string to_json(const JournalHead& head);

/// How the job of a record is another one than that of `head`, in words; empty: it is the same job,
/// and the same part of it. Its engines may be others.
std::string job_difference(const JournalHead& head, const JournalHead& record);

/// How the engines of a record differ, in words; empty: they are the same, in the same order.
std::string engine_difference(const JournalHead& head, const JournalHead& record);

/// The line with a sum of all of it at its end, by which a line is known that was damaged. `line`
/// is a JSON object of at least one member.
std::string sealed(std::string_view line);

/// A comparison in a file, line by line: behind the head come the places, all in their order, as
/// many as there are so far. A last line without a break is what a run was writing when it was
/// stopped, and is no part of it.
class JournalReader {
 public:
  /// Reads the head. Throws CaseError, naming file and line, for what is no record of a comparison.
  explicit JournalReader(const std::filesystem::path& path);

  const JournalHead& head() const { return head_; }

  /// The next line, or false at the end. Throws CaseError for a line whose sum is another.
  bool next(std::string& line);

  /// Where the last line stands that was read: "run.jsonl:7".
  const std::string& place() const { return place_; }

  /// How many bytes were read, all of whole lines.
  std::uint64_t bytes() const { return bytes_; }

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::size_t number_ = 0;
  std::uint64_t bytes_ = 0;
  std::string place_;
  JournalHead head_;
};

/// The record of a run that may be stopped at any time, and goes on then: each line is handed to
/// the system as it is added. Nobody else may write it meanwhile. A pipe or a device is written
/// through.
class JournalFile {
 public:
  /// Opens the file, or makes it, for this process alone. Throws CaseError, also if another run is
  /// writing it.
  explicit JournalFile(const std::filesystem::path& path);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Whether there are whole lines of an earlier run.
  bool has_record(const JournalHead& head) const;

  /// Takes the place of what was there.
  void begin(const JournalHead& head);
  /// Goes on behind so many bytes.
  void go_on(std::uint64_t bytes);
  void add(std::string_view line);

 private:
  void write(std::string_view bytes);
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;
  int descriptor_ = -1;                         ///< of a regular file
  std::unique_ptr<files::OutputFile> through_;  ///< of what is none
};

}  // namespace graze::compare
