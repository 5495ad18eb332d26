#include <graze/bvh/error.h>
#include <graze/engine/cli/compare/compare_output.h>
#include <graze/engine/cli/compare/merge_run.h>
#include <graze/engine/cli/compare/recorded_run.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/compare/run/record/place_block.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <optional>

namespace graze::cli {
namespace {

using compare::JournalHead;
using compare::PlaceRecord;

struct PartFile {
  std::string path;
  JournalHead head;
};

std::string named(const PartFile& part) {
  return mesh_io::printable(part.path);
}

[[noreturn]] void refuse(const PartFile& part, const std::string& why) {
  throw CaseError(named(part) + ": " + why);
}

void check_same_job(const PartFile& first, const PartFile& part) {
  JournalHead head = first.head;
  const std::string mine = fmt::format("part of {}", part.head.part.count);
  if (part.head.part.count != head.part.count) {
    refuse(part, fmt::format("is {}, and {} is part of {}", mine, named(first), head.part.count));
  }
  head.part = part.head.part;
  std::string difference = compare::job_difference(head, part.head);
  if (difference.empty()) difference = compare::engine_difference(head, part.head);
  if (!difference.empty()) refuse(part, "is not of the job of " + named(first) + ": " + difference);
}

/// Returns all parts in their order, each once.
std::vector<PartFile> read_parts(const std::vector<std::string>& paths) {
  std::vector<PartFile> parts;
  for (const std::string& path : paths) {
    parts.push_back({path, compare::JournalReader(path).head()});
    if (parts.back().head.kind != "graze_comparison") {
      refuse(parts.back(), "is no record of two meshes: others have no parts");
    }
    check_same_job(parts.front(), parts.back());
  }
  const auto number = [](const PartFile& part) { return part.head.part.number; };
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const PartFile& a, const PartFile& b) { return number(a) < number(b); });
  const std::size_t count = parts.front().head.part.count;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0 && number(parts[i]) == number(parts[i - 1])) {
      refuse(parts[i], fmt::format("is part {} of {}, and so is {}", number(parts[i]), count,
                                   named(parts[i - 1])));
    }
    if (number(parts[i]) != i + 1)
      throw CaseError(fmt::format("part {} of {} is missing", i + 1, count));
  }
  if (parts.size() < count) {
    throw CaseError(fmt::format("part {} of {} is missing", parts.size() + 1, count));
  }
  return parts;
}

void check_places(const MergeOptions& options) {
  const std::array<FilePlace, 3> outputs = {
      {{"--save", options.save}, {"--junit", options.junit}, {"--markdown", options.markdown}}};
  std::vector<FilePlace> inputs;
  for (const std::string& part : options.parts)
    inputs.push_back({"a part", part});
  check_outputs(outputs, inputs);
}

CompareFindings no_findings(const MergeOptions& options, const JournalHead& head) {
  std::vector<std::string> names;
  for (const compare::JournalEngine& engine : head.engines)
    names.push_back(engine.name);
  const FailOn fail_on(options.fail_on, {}, names);
  if (fail_on.names_changes()) {
    throw UsageError("--fail-on: what has changed is known to compare --against alone");
  }
  CompareFindings findings{.title = fmt::format("{} parts", options.parts.size()),
                           .question = "",
                           .count = fmt::format("{} poses", head.places),
                           .place = "pose",
                           .summaries = {},
                           .wrong = {0, fail_on, {}}};
  for (const compare::JournalPart& part : head.parts)
    if (part.name == "question") findings.question = part.value;
  return findings;
}

/// Takes every record, in the order of places.
class Merged {
 public:
  Merged(const MergeOptions& options, const JournalHead& head, CompareFindings& findings)
      : findings_(findings),
        progress_("poses:", head.places, {.is_forced = options.has_progress, .has_rows = false}) {
    job_.head = head;
    job_.head.part = {};
    job_.write = [this](std::span<const PlaceRecord> block) {
      return to_json(block, job_.head.engines);
    };
    job_.most_in_line = compare::kPlacesOfBlock;
    if (options.save.empty()) return;
    file_.emplace(options.save);
    const auto add = [this](const std::string& line) {
      file_->append(compare::sealed(line) + "\n");
    };
    add(to_json(job_.head));
    writer_.emplace(job_, add);
  }

  void add(const PartFile& part) {
    compare::JournalReader file(part.path);
    job_.read = [&](const cases::JsonCursor& at, std::size_t first) {
      return compare::read_place_block(at, part.head.engines, first, part.head.end());
    };
    RecordReader<PlaceRecord> reader(file, job_);
    const std::size_t first = done_;
    while (const PlaceRecord* record = reader.next())
      add(*record);
    if (done_ == part.head.end()) return;
    refuse(part, fmt::format("has {} of its {} poses: the command that made it goes on with it",
                             done_ - first, part.head.end() - part.head.first()));
  }

  void finish() {
    if (writer_) writer_->flush();
    if (file_) file_->finish();
    findings_.summaries = tally_.summaries();
    findings_.rows = wrong_rows(findings_.wrong.kept(), findings_.wrong.count(), "pose");
  }

 private:
  void add(const PlaceRecord& record) {
    tally_.add(record);
    for (compare::WrongAnswer& wrong : wrong_answers(record))
      findings_.wrong.add(std::move(wrong));
    if (writer_) writer_->add(record);
    ++done_;
    if (progress_.is_due()) progress_.update(done_, tally_.note());
  }

  CompareFindings& findings_;
  Progress progress_;
  RecordedJob<PlaceRecord> job_;
  std::optional<files::OutputFile> file_;
  std::optional<RecordWriter<PlaceRecord>> writer_;
  Tally tally_;
  std::size_t done_ = 0;
};

}  // namespace

ExitCode run_merge(const MergeOptions& options, Output& output) {
  check_places(options);
  const std::vector<PartFile> parts = read_parts(options.parts);
  CompareFindings findings = no_findings(options, parts.front().head);
  Merged merged(options, parts.front().head, findings);
  for (const PartFile& part : parts)
    merged.add(part);
  merged.finish();
  CompareOptions as_compared;
  as_compared.fail_on = options.fail_on;
  as_compared.junit = options.junit;
  as_compared.markdown = options.markdown;
  as_compared.is_json = options.is_json;
  return conclude(as_compared, {}, {}, findings, output);
}

}  // namespace graze::cli
