#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <graze/engine/cli/compare/compare_output.h>
#include <graze/engine/cli/output/interruption.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/compare/run/record/baseline.h>
#include <graze/engine/compare/run/record/journal.h>
#include <graze/engine/compare/run/trial_threads.h>
#include <graze/engine/files/output_file.h>

namespace graze::cli {

/// Describes a comparison that goes from place to place, and of which a record can be kept.
template <typename Record>
struct RecordedJob {
  compare::JournalHead head;
  /// Returns what a line of its record holds, from the place `first` on.
  std::function<std::vector<Record>(const cases::JsonCursor&, std::size_t first)> read = {};
  /// Returns a line of places that follow each other.
  std::function<std::string(std::span<const Record>)> write = {};
  std::size_t most_in_line = 1;
  /// Goes through the places of the range, and hands on records in their order, until it is told to
  /// stop.
  std::function<void(const compare::PlaceRange& range,
                     const std::function<bool(std::vector<Record>)>& on_records)>
      run = {};
  /// Called with each record once, in their order.
  std::function<void(const Record&)> on_record = {};
  /// Returns what is told while the job runs, besides how far it came.
  std::function<std::string()> note = {};
};

/// Reads the records in a file, one by one.
template <typename Record>
class RecordReader {
 public:
  RecordReader(compare::JournalReader& file, const RecordedJob<Record>& job)
      : file_(file), job_(job), next_(file.head().first()) {}

  /// Returns the next record, or null at the end. Throws CaseError, naming file and line.
  const Record* next() {
    while (at_ == block_.size()) {
      std::string line;
      if (!file_.next(line)) return nullptr;
      const cases::JsonValue tree = cases::parse_json(line, file_.place());
      block_ = job_.read(cases::JsonCursor(tree, file_.place()), next_);
      next_ += block_.size();
      at_ = 0;
    }
    return &block_[at_++];
  }

 private:
  compare::JournalReader& file_;
  const RecordedJob<Record>& job_;
  std::size_t next_;  ///< a place in the job
  std::vector<Record> block_;
  std::size_t at_ = 0;
};

/// Puts records together to lines.
template <typename Record>
class RecordWriter {
 public:
  RecordWriter(const RecordedJob<Record>& job, std::function<void(const std::string&)> on_line)
      : job_(job), on_line_(std::move(on_line)) {}

  void add(const Record& record) {
    block_.push_back(record);
    if (block_.size() == job_.most_in_line) flush();
  }
  void flush() {
    if (!block_.empty()) on_line_(job_.write(block_));
    block_.clear();
  }

 private:
  const RecordedJob<Record>& job_;
  std::function<void(const std::string&)> on_line_;
  std::vector<Record> block_;
};

/// Runs a job once, with what it is resumed from, what it writes and what it is held against.
template <typename Record>
class RecordedRun {
 public:
  RecordedRun(const CompareOptions& options, const RecordedJob<Record>& job)
      : options_(options),
        job_(job),
        progress_(job.head.unit + ":", job.head.end() - job.head.first(),
                  {.is_forced = options.has_progress, .has_rows = false}) {}

  /// Goes on where --resume ended, keeps its record, and writes --save. Bad input, also that of
  /// --against, is refused before the run. Returns what --against found. Throws UsageError,
  /// CaseError, Interrupted once what was begun is recorded, and what the job throws.
  std::optional<std::vector<compare::EngineChange>> run() {
    open_baseline();
    if (!options_.save.empty()) open_save();
    std::optional<Interruption> interruption;
    if (!options_.resume.empty()) {
      interruption.emplace();  // without a record there is none to go on with
      go_on();
    }
    const std::size_t first = job_.head.first() + done_;
    const std::size_t end = job_.head.end();
    const auto on_records = [&](std::vector<Record> records) {
      for (const Record& record : records)
        deliver(record, true);
      const bool is_stopped = interruption && Interruption::is_requested();
      if (resume_ && (is_stopped || Clock::now() >= next_flush_)) flush();
      return !is_stopped;
    };
    job_.run({.first = first, .end = end, .threads = options_.threads}, on_records);
    if (resume_) flush();
    if (first + fresh_ < end) {
      throw Interrupted(interruption_text(options_, job_.head, done_));
    }
    if (save_) save_->flush();
    if (save_file_) save_file_->finish();
    return changes();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kFlushInterval{1};

  void open_baseline() {
    if (options_.against.empty()) return;
    baseline_file_.emplace(options_.against);
    check_baseline(options_, job_.head, baseline_file_->head());
    baseline_reader_.emplace(*baseline_file_, job_);
    baseline_.emplace(options_.answer_tolerance);
  }

  void open_save() {
    save_file_.emplace(options_.save);
    const auto add = [this](const std::string& line) {
      save_file_->append(compare::sealed(line) + "\n");
    };
    add(to_json(job_.head));
    save_.emplace(job_, add);
  }

  /// Takes first what there is of an earlier run of the same job; a pipe or a device has nothing.
  void go_on() {
    resume_file_.emplace(options_.resume);
    if (resume_file_->has_record(job_.head)) {
      compare::JournalReader file(options_.resume);
      check_resumed(options_, job_.head, file.head());
      RecordReader<Record> reader(file, job_);
      while (const Record* record = reader.next())
        deliver(*record, false);
      resume_file_->go_on(file.bytes());
    } else {
      resume_file_->begin(job_.head);
    }
    resume_.emplace(job_, [this](const std::string& line) { resume_file_->add(line); });
  }

  void flush() {
    resume_->flush();
    next_flush_ = Clock::now() + kFlushInterval;
  }

  void deliver(const Record& record, bool is_fresh) {
    if (is_fresh) {
      ++fresh_;
      if (resume_) resume_->add(record);
    }
    ++done_;
    if (save_) save_->add(record);
    if (baseline_) {
      const Record* before = baseline_reader_->next();
      baseline_->add(record.place,
                     before == nullptr ? std::vector<compare::SaidThere>() : said_there(*before),
                     said_there(record));
    }
    job_.on_record(record);
    if (progress_.is_due()) progress_.update(done_, job_.note());
  }

  std::optional<std::vector<compare::EngineChange>> changes() {
    if (!baseline_) return std::nullopt;
    baseline_reader_->next();  // it throws for places that do not exist
    return baseline_->changes();
  }

  const CompareOptions& options_;
  const RecordedJob<Record>& job_;
  std::size_t done_ = 0;
  std::size_t fresh_ = 0;  ///< the number of these that were done in this run
  Progress progress_;
  std::optional<compare::JournalReader> baseline_file_;
  std::optional<RecordReader<Record>> baseline_reader_;
  std::optional<compare::Baseline> baseline_;
  std::optional<files::OutputFile> save_file_;
  std::optional<RecordWriter<Record>> save_;
  std::optional<compare::JournalFile> resume_file_;
  std::optional<RecordWriter<Record>> resume_;
  Clock::time_point next_flush_ = Clock::now() + kFlushInterval;
};

}  // namespace graze::cli
