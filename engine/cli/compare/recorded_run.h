#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <graze/engine/cli/compare/compare_output.h>
#include <graze/engine/cli/output/interruption.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/compare/run/journal.h>
#include <graze/engine/files/output_target.h>

namespace graze::cli {

/// A comparison that goes from place to place, and of which a record can be kept.
template <typename Record>
struct RecordedJob {
  compare::JournalHead head;
  std::function<Record(const cases::JsonCursor&)> read;
  std::function<std::string(const Record&)> write;
  /// Does what is not done, and hands on each record as it comes.
  std::function<void(const std::function<bool(std::size_t)>& is_done,
                     const std::function<void(Record)>& on_record)>
      run;
};

template <typename Record>
struct RecordedRun {
  std::vector<Record> records;                            ///< in the order of places
  std::optional<compare::BaselineDifference> difference;  ///< from --against
};

/// Thrown through a job to end it.
class Stop {};

/// The records of an earlier run of the same job, if there was one: of a pipe or a device there is
/// none, and the record of this run is written through.
template <typename Record>
std::vector<Record> resumed(const CompareOptions& options, const RecordedJob<Record>& job,
                            std::span<const compare::EngineEntry> engines) {
  if (options.resume.empty() || !files::find_output_target(options.resume).old) return {};
  compare::Journal<Record> journal = compare::read_journal(options.resume, job.head, job.read);
  check_resumed(options, journal.start, engines);
  return std::move(journal.records);
}

/// Goes on where --resume ended, keeps its record, and writes --save. Bad input, of --against too,
/// is refused before the run. Throws UsageError, CaseError, Interrupted once what was begun is
/// recorded, and what the job throws.
template <typename Record>
RecordedRun<Record> run_recorded(const CompareOptions& options, const RecordedJob<Record>& job,
                                 std::span<const compare::EngineEntry> engines) {
  const auto parts_of = [](const std::vector<Record>& records) {
    std::vector<compare::GrazePart> parts;
    parts.reserve(records.size());
    for (const Record& record : records)
      parts.push_back(graze_part(record));
    return parts;
  };
  const auto lines_of = [&](const std::vector<Record>& records) {
    std::vector<std::string> lines;
    lines.reserve(records.size());
    for (const Record& record : records)
      lines.push_back(job.write(record));
    return lines;
  };
  std::vector<compare::GrazePart> baseline;
  if (!options.against.empty()) {
    const compare::Journal<Record> old = compare::read_journal(options.against, job.head, job.read);
    check_baseline(options, old.start);
    baseline = parts_of(old.records);
  }
  RecordedRun<Record> result;
  std::vector<Record>& records = result.records;
  records = resumed(options, job, engines);
  std::vector<bool> is_done(job.head.places, false);
  for (const Record& record : records)
    is_done[record.place] = true;
  std::optional<compare::LineFile> journal;
  if (!options.resume.empty()) {
    journal = compare::start_journal(options.resume, job.head, engines, lines_of(records));
  }
  {
    Progress progress(job.head.unit + ":", job.head.places,
                      {.is_forced = options.has_progress, .has_rows = false});
    std::optional<Interruption> interruption;
    if (journal) interruption.emplace();  // without a record there is nothing to go on with
    try {
      job.run([&](std::size_t place) { return is_done[place]; },
              [&](Record record) {
                if (journal) journal->add(job.write(record));
                records.push_back(std::move(record));
                progress.update(records.size());
                if (interruption && Interruption::is_requested()) throw Stop();
              });
    } catch (const Stop&) {  // all threads have finished what they had begun
    }
  }
  if (records.size() < job.head.places) {
    throw Interrupted(interruption_text(options, job.head, records.size()));
  }
  std::sort(records.begin(), records.end(),
            [](const Record& a, const Record& b) { return a.place < b.place; });
  if (!options.save.empty()) {
    compare::start_journal(options.save, job.head, engines, lines_of(records));
  }
  if (!options.against.empty()) {
    result.difference = compare_to_baseline(baseline, parts_of(records));
  }
  return result;
}

}  // namespace graze::cli
