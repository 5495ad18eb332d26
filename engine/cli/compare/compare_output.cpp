#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/advice_list.h>
#include <graze/engine/cli/compare/compare_output.h>
#include <graze/engine/cli/compare/gate_files.h>
#include <graze/engine/cli/compare/html_report.h>
#include <graze/engine/cli/compare/shell_word.h>
#include <graze/engine/cli/files/case_folder.h>
#include <graze/engine/cli/files/mesh_copies.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/replay/fail_on.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <hwy/targets.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <set>
#include <utility>

namespace graze::cli {

namespace fs = std::filesystem;

namespace {

/// Returns the SIMD instructions that this program uses on this machine: "AVX2". No answer depends
/// on it.
const char* simd_target() {
  const std::int64_t usable = hwy::SupportedTargets() & static_cast<std::int64_t>(HWY_TARGETS);
  return hwy::TargetName(usable & -usable);  // the lowest bit stands for the best
}

FailOn fail_on_of(const CompareOptions& options, std::span<const compare::EngineEntry> field) {
  return {options.fail_on, field, {}};
}

}  // namespace

void check_before(const CompareOptions& options, std::span<const compare::EngineEntry> field) {
  if (fail_on_of(options, field).names_changes() && options.against.empty()) {
    throw UsageError("--fail-on: what has changed is known with --against alone");
  }
  const FilePlace report = {"--report", options.report};
  const FilePlace junit = {"--junit", options.junit};
  const FilePlace markdown = {"--markdown", options.markdown};
  const FilePlace save = {"--save", options.save};
  const FilePlace resume = {"--resume", options.resume};
  for (const FilePlace& place : {report, junit, markdown, save, resume}) {
    if (place.path.empty()) continue;
    const fs::path folder = fs::path(place.path).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored)) {
      throw UsageError(fmt::format("{}: {}: there is no folder {}", place.name,
                                   mesh_io::printable(place.path),
                                   mesh_io::printable(folder.string())));
    }
    if (fs::is_directory(place.path, ignored)) {
      throw UsageError(
          fmt::format("{}: {}: is a folder", place.name, mesh_io::printable(place.path)));
    }
  }
  const std::array<FilePlace, 3> inputs = {{{"A itself", options.mesh_a},
                                            {"B itself", options.mesh_b},
                                            {"the file of --poses", options.poses.value_or("")}}};
  check_outputs(std::array{report, junit, markdown, save, resume}, inputs);
  // A gate may be held against the same file that it saves for the next time: that is read before.
  const FilePlace against = {"the file of --against", options.against};
  check_outputs(std::array{report, junit, markdown, resume}, {&against, 1});
  std::error_code ignored;
  if (!options.cases.empty() && fs::exists(options.cases, ignored) &&
      !fs::is_directory(options.cases, ignored)) {
    throw UsageError("--cases: " + mesh_io::printable(options.cases) + ": is no folder");
  }
}

WrongList wrong_list_of(const CompareOptions& options,
                        std::span<const compare::EngineEntry> field) {
  std::set<std::string> have_cases;
  for (const compare::EngineEntry& entry : field)
    if (entry.engine != nullptr) have_cases.insert(entry.name);
  return {options.keep, fail_on_of(options, field), std::move(have_cases)};
}

void check_resumed(const CompareOptions& options, const compare::JournalHead& head,
                   const compare::JournalHead& record) {
  const std::string file = "--resume: " + mesh_io::printable(options.resume);
  const std::string difference = compare::job_difference(head, record);
  if (!difference.empty()) {
    throw UsageError(file + " is a record of something else: " + difference);
  }
  const std::string engines = compare::engine_difference(head, record);
  if (!engines.empty()) throw UsageError(file + " cannot be gone on with: " + engines);
}

void check_baseline(const CompareOptions& options, const compare::JournalHead& head,
                    const compare::JournalHead& record) {
  const std::string difference = compare::job_difference(head, record);
  if (difference.empty()) return;
  throw UsageError("--against: " + mesh_io::printable(options.against) +
                   " is a record of something else: " + difference);
}

std::string interruption_text(const CompareOptions& options, const compare::JournalHead& head,
                              std::size_t done) {
  return fmt::format("interrupted: {} of {} {} done, go on with --resume {}", done,
                     head.end() - head.first(), head.unit, mesh_io::printable(options.resume));
}

namespace {

/// Holds what is said of an older run, and whether that is a regression.
struct Regression {
  bool is_one = false;
  std::string words;
  std::string json;
};

/// Returns "poses 3 7 and 12 more".
std::string places_of(const CompareFindings& findings, const compare::EngineChange& change) {
  std::string text = " in " + findings.place + "s";
  for (const std::size_t place : change.places) {
    text += " " + (place < findings.names.size() ? mesh_io::printable(findings.names[place])
                                                 : std::to_string(place));
  }
  const std::size_t more = change.changed - change.places.size();
  return text + (more == 0 ? "" : fmt::format(" and {} more", more));
}

/// Returns what changed of one engine, and who was right before and after.
std::string words_of(const CompareFindings& findings, const compare::EngineChange& change) {
  std::string text =
      fmt::format("{} answers of {} changed", change.changed, mesh_io::printable(change.engine));
  if (change.changed > 0) text += places_of(findings, change);
  const std::size_t judged = change.right_to_wrong + change.wrong_to_right + change.wrong_to_wrong;
  if (judged > 0) {
    text += fmt::format(" ({} from right to wrong, {} from wrong to right, {} wrong both times)",
                        change.right_to_wrong, change.wrong_to_right, change.wrong_to_wrong);
  }
  return text + fmt::format(", {} missing", change.missing);
}

std::string json_of(const compare::EngineChange& change) {
  return fmt::format(
      "{{\"engine\":{},\"compared\":{},\"changed\":{},\"first_changed\":[{}],\"missing\":{},"
      "\"right_to_wrong\":{},\"wrong_to_right\":{},\"wrong_to_wrong\":{},\"time_ratio\":{:.3f}}}",
      cases::json_string(change.engine), change.compared, change.changed,
      fmt::join(change.places, ","), change.missing, change.right_to_wrong, change.wrong_to_right,
      change.wrong_to_wrong, change.time_ratio);
}

/// Finds regressions: every change of graze is one, so are changes that --fail-on ENGINE:changed
/// names, and so is a slower graze.
Regression regression_of(const CompareOptions& options, const CompareFindings& findings) {
  if (!findings.changes) return {};
  Regression result;
  std::string engines;
  result.words = "against " + mesh_io::printable(options.against) + ": ";
  bool is_slower = false;
  for (const compare::EngineChange& change : *findings.changes) {
    const bool is_graze = change.engine == "graze";
    const bool counts = is_graze || findings.wrong.fail_on().matches_change(change.engine);
    result.is_one |= counts && (change.changed > 0 || change.missing > 0);
    result.words += (engines.empty() ? "" : "\n  ") + words_of(findings, change);
    engines += (engines.empty() ? "" : ",") + json_of(change);
    if (!is_graze) continue;
    is_slower = change.time_ratio > options.time_tolerance;
    result.words +=
        fmt::format("; median time {:.2f} of what it was{}", change.time_ratio,
                    is_slower ? fmt::format(", more than {:.2f}", options.time_tolerance) : "");
  }
  result.is_one |= is_slower;
  result.json =
      fmt::format("{{\"against\":{{\"engines\":[{}],\"slower\":{}}}}}\n", engines, is_slower);
  return result;
}

/// Returns what --fail-on has found; nothing where nobody has asked.
std::string fail_on_text(const CompareOptions& options, const CompareFindings& findings) {
  if (options.fail_on.empty()) return "";
  const std::size_t count = findings.wrong.named_by_fail_on();
  return options.is_json
             ? fmt::format("{{\"fail_on\":{}}}\n", count)
             : fmt::format("{} wrong answer{} of --fail-on\n", count, count == 1 ? "" : "s");
}

std::string says_of(const compare::ShrunkCase& each) {
  return each.query.answer ? compare::brief(*each.query.answer) : "nothing";
}

/// Holds what became of the cases.
struct KeptCases {
  std::vector<WrittenCase> cases;
  std::string folder;
  std::size_t not_written = 0;
  std::string failure;     ///< why the first of these failed
  std::size_t others = 0;  ///< cases that were in the folder before
};

std::string row_of(const WrittenCase& each) {
  const std::string remark =
      each.shrunk.is_stopped ? "the time was over: see --shrink-seconds" : each.least;
  const std::string what = each.is_recorded ? "recorded" : "shrunk";
  return what + (each.is_written ? ": graze replay " : ", not written: ") + shell_word(each.file) +
         (remark.empty() ? "" : " (" + remark + ")") + "\n";
}

std::string text_of(const CompareFindings& findings, const KeptCases& kept,
                    std::span<const compare::EngineEntry> engines) {
  std::string text;
  for (const compare::EngineEntry& entry : engines) {
    if (entry.engine != nullptr || entry.is_only_if_named) continue;
    text += entry.name + ": not found when this command was built\n";
  }
  text += findings.rows;
  for (const WrittenCase& each : kept.cases)
    text += row_of(each);
  if (kept.others > 0) {
    text += fmt::format("{} also holds {} case{} of other runs\n", mesh_io::printable(kept.folder),
                        kept.others, kept.others == 1 ? "" : "s");
  }
  return text + findings.count + "\n" + summary_text(findings.summaries);
}

bool is_recorded(std::span<const compare::EngineEntry> field, const std::string& engine) {
  return std::any_of(field.begin(), field.end(), [&](const compare::EngineEntry& each) {
    return each.name == engine && each.recorded != nullptr;
  });
}

/// Writes each case as soon as there is something to keep, and again as it gets smaller. A case
/// that cannot be made smaller stays in the file that it came from, if it came from one.
KeptCases keep_cases(const CompareOptions& options, std::span<const compare::EngineEntry> field,
                     const CompareFindings& findings, std::span<const compare::WrongAnswer> wrong) {
  KeptCases kept;
  kept.folder = options.cases.empty() ? kDefaultCases : options.cases;
  CaseFolder folder(kept.folder);
  const MeshCopies copies(kept.folder, options.mesh_a, options.mesh_b);
  std::string name;  // the name of the case at hand; its digest is of all of it
  std::size_t at_hand = wrong.size();
  bool is_written = false;
  const auto write = [&](const compare::ShrunkCase& each) {
    const compare::WrongAnswer& from = wrong[each.wrong];
    if (each.wrong != at_hand) {
      Case question = from.query();
      question.answered_by = each.query.answered_by;
      name = case_file_name(from.name, name_of(from.answer->judgement.error_class), question);
      at_hand = each.wrong;
      is_written = false;
    }
    if (!each.is_smaller && !from.origin.empty()) return;
    Case query = each.query;
    query.note = fmt::format("{}, {} {}: {} says {}, the truth is: {} ({})", findings.title,
                             findings.place, from.where, each.engine, says_of(each),
                             each.judgement.truth, name_of(each.judgement.error_class));
    // An answer that is none goes into no file: whoever replays the case sees it again.
    if (each.judgement.error_class == compare::ErrorClass::EngineError) query.answer.reset();
    is_written = folder.write(name, is_recorded(field, each.engine) ? copies.refer(query) : query);
  };
  const auto keep = [&](compare::ShrunkCase each) {
    const compare::WrongAnswer& from = wrong[each.wrong];
    const bool is_at_its_origin = !each.is_smaller && !from.origin.empty();
    const std::string file = is_at_its_origin ? from.origin : folder.path(name).string();
    const std::string says = says_of(each);
    const std::string least = compare::least_size(each);
    const bool is_there = is_at_its_origin || is_written;
    kept.not_written += !is_there;
    const bool was_recorded = is_recorded(field, each.engine);
    kept.cases.push_back(
        {std::move(each), from.place, from.where, file, says, least, is_there, was_recorded});
  };
  Progress progress("cases shrunk:", std::min(wrong.size(), options.keep),
                    {.is_forced = options.has_progress, .has_rows = false});
  compare::shrink_worst(wrong, field,
                        {.limit = options.keep,
                         .time = std::chrono::duration<double>(options.shrink_seconds),
                         .on_case = write,
                         .on_done = keep,
                         .on_progress = [&](std::size_t done) { progress.update(done); }});
  if (kept.not_written > 0) kept.failure = folder.failure();
  if (!kept.cases.empty()) kept.others = folder.count_others();
  return kept;
}

std::vector<ReportFact> facts_of(const CompareOptions& options, const CompareFindings& findings,
                                 std::span<const compare::EngineEntry> field) {
  std::vector<ReportFact> facts;
  if (!options.command.empty()) facts.push_back({"command", options.command});
  std::string engines;
  for (const compare::EngineEntry& entry : field) {
    if (entry.engine == nullptr) continue;
    const std::string version = entry.engine->name().version;
    engines += (engines.empty() ? "" : ", ") + entry.name + (version.empty() ? "" : " " + version);
  }
  facts.push_back({"engines", engines});
  facts.push_back({"SIMD target of graze", simd_target()});
  if (options.random > 0 || options.grazing > 0) {
    facts.push_back({"seed", std::to_string(options.seed.value_or(1))});
  }
  for (const compare::JournalPart& part : findings.asked) {
    const bool is_hash = part.value.size() == 64;
    facts.push_back({part.name, (is_hash ? "SHA-256 " : "") + part.value});
  }
  return facts;
}

}  // namespace

ExitCode conclude(const CompareOptions& options, std::span<const compare::EngineEntry> engines,
                  std::span<const compare::EngineEntry> field, const CompareFindings& findings,
                  Output& output) {
  const std::vector<compare::WrongAnswer> wrong = findings.wrong.kept();
  const KeptCases kept = keep_cases(options, field, findings, wrong);
  const std::vector<compare::Advice> advice = advice_of(options, findings, kept.cases, field);
  if (!options.report.empty()) {
    write_report(options.report, {.mesh_a = options.mesh_a,
                                  .mesh_b = options.mesh_b,
                                  .query = findings.question,
                                  .places = findings.count,
                                  .place = findings.place,
                                  .facts = facts_of(options, findings, field),
                                  .summaries = findings.summaries,
                                  .wrong = wrong,
                                  .wrong_count = findings.wrong.count(),
                                  .cases = kept.cases,
                                  .advice = advice_html(advice),
                                  .viewer = report_viewer(kept.cases, findings.place)});
  }
  const Regression regression = regression_of(options, findings);
  const Gate gate{.is_closed = findings.wrong.closes_gate() || regression.is_one,
                  .regression = regression.is_one ? regression.words : ""};
  if (!options.junit.empty()) files::write_file(options.junit, junit_text(findings, gate));
  if (!options.markdown.empty())
    files::write_file(options.markdown, markdown_text(findings, gate, advice));
  if (options.is_json) {
    output.write(findings.json + advice_json(advice) +
                 summary_json(findings.summaries, kept.cases, findings.place) + regression.json +
                 fail_on_text(options, findings));
  } else {
    output.write(text_of(findings, kept, engines) + advice_text(advice) +
                 (findings.changes ? regression.words + "\n" : "") +
                 fail_on_text(options, findings));
  }
  if (kept.not_written > 0) {
    std::fprintf(stderr, "graze: %zu case%s not written: %s\n", kept.not_written,
                 kept.not_written == 1 ? "" : "s", kept.failure.c_str());
  }
  if (gate.is_closed) return ExitCode::GrazeWrong;
  const bool is_missed = kept.not_written > 0 && !options.cases.empty();  // their folder is named
  return is_missed ? ExitCode::BadInput : ExitCode::Answered;
}

}  // namespace graze::cli
