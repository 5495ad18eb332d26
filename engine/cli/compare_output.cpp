#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/compare_output.h>
#include <graze/engine/cli/html_report.h>
#include <graze/engine/cli/simd_target.h>
#include <graze/engine/cli/usage_error.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/mesh/io/source.h>

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <utility>

namespace graze::cli {

namespace fs = std::filesystem;

void check_places(const CompareOptions& options) {
  for (const auto& [name, file] :
       {std::pair{"--report", &options.report}, std::pair{"--save", &options.save},
        std::pair{"--resume", &options.resume}}) {
    if (file->empty()) continue;
    const fs::path folder = fs::path(*file).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored)) {
      throw UsageError(fmt::format("{}: {}: there is no folder {}", name, mesh_io::printable(*file),
                                   mesh_io::printable(folder.string())));
    }
    if (fs::is_directory(*file, ignored)) {
      throw UsageError(fmt::format("{}: {}: is a folder", name, mesh_io::printable(*file)));
    }
  }
  std::error_code ignored;
  if (fs::exists(options.cases, ignored) && !fs::is_directory(options.cases, ignored)) {
    throw UsageError("--cases: " + mesh_io::printable(options.cases) + ": is no folder");
  }
}

void check_resumed(const CompareOptions& options, const compare::JournalStart& start,
                   std::span<const compare::EngineEntry> engines_now) {
  const std::string file = mesh_io::printable(options.resume);
  if (!start.is_same_job) {
    throw UsageError("--resume: " + file + " is a record of something else: " + start.difference);
  }
  const bool are_same =
      std::equal(start.engines.begin(), start.engines.end(), engines_now.begin(), engines_now.end(),
                 [](const std::string& name, const compare::EngineEntry& entry) {
                   return name == entry.name;
                 });
  if (are_same) return;
  std::string names;
  for (const std::string& name : start.engines)
    names += (names.empty() ? "" : ",") + mesh_io::printable(name);
  throw UsageError("--resume: " + file + " is of other engines: " + names);
}

void check_baseline(const CompareOptions& options, const compare::JournalStart& start) {
  if (start.is_same_job) return;
  throw UsageError("--against: " + mesh_io::printable(options.against) +
                   " is a record of something else: " + start.difference);
}

std::string interruption_text(const CompareOptions& options, const compare::JournalHead& head,
                              std::size_t done) {
  return fmt::format("interrupted: {} of {} {} done, go on with --resume {}", done, head.places,
                     head.unit, mesh_io::printable(options.resume));
}

namespace {

/// What is said of an older run, and whether that is a regression.
struct Regression {
  bool is_one = false;
  std::string text;
};

Regression regression_of(const CompareOptions& options, const CompareFindings& findings) {
  if (!findings.difference) return {};
  const compare::BaselineDifference& found = *findings.difference;
  const double ratio = found.time_ratio;
  const bool is_slower = ratio > options.time_tolerance;
  Regression result;
  result.is_one = !found.changed.empty() || !found.missing.empty() || is_slower;
  if (options.is_json) {
    result.text = fmt::format(
        "{{\"against\":{{\"changed\":[{}],\"missing\":[{}],\"time_ratio\":{:.3f},\"slower\":{}}}}}"
        "\n",
        fmt::join(found.changed, ","), fmt::join(found.missing, ","), ratio, is_slower);
    return result;
  }
  std::string where;
  for (const std::size_t place : found.changed) {
    where += " " + (place < findings.names.size() ? mesh_io::printable(findings.names[place])
                                                  : std::to_string(place));
  }
  result.text = fmt::format(
      "against {}: {} answers of graze changed{}, {} missing; median time {:.2f} of what it "
      "was{}\n",
      mesh_io::printable(options.against), found.changed.size(),
      where.empty() ? "" : fmt::format(" in {}s{}", findings.place, where), found.missing.size(),
      ratio, is_slower ? fmt::format(", more than {:.2f}", options.time_tolerance) : "");
  return result;
}

bool is_graze_wrong(std::span<const compare::WrongAnswer> wrong) {
  return std::any_of(wrong.begin(), wrong.end(), [](const compare::WrongAnswer& each) {
    return each.answer->engine == "graze" || each.answer->engine == "world";
  });
}

std::string text_of(const CompareFindings& findings, std::span<const WrittenCase> cases,
                    std::span<const compare::EngineEntry> engines) {
  std::string text;
  for (const compare::EngineEntry& entry : engines) {
    if (entry.engine == nullptr) text += entry.name + ": not found when this command was built\n";
  }
  text += findings.rows;
  for (const WrittenCase& each : cases)
    text += "shrunk: graze replay " + mesh_io::printable(each.file) +
            (each.least.empty() ? "" : " (" + each.least + ")") + "\n";
  return text + findings.count + "\n" + summary_text(findings.summaries);
}

/// A case that cannot be made smaller stays in the file that it came from, if it came from one.
std::vector<WrittenCase> write_cases(const CompareOptions& options,
                                     std::span<const compare::EngineEntry> field,
                                     const CompareFindings& findings) {
  std::vector<WrittenCase> written;
  if (options.cases.empty()) return written;
  for (compare::ShrunkCase& each : compare::shrink_worst(findings.wrong, field, options.keep)) {
    const compare::WrongAnswer& from = findings.wrong[each.wrong];
    const std::string says = each.query.answer ? compare::brief(*each.query.answer) : "nothing";
    const auto add = [&](compare::ShrunkCase& shrunk, const std::string& file) {
      const std::string least = compare::least_size(shrunk);
      written.push_back({std::move(shrunk), from.place, from.where, file, says, least});
    };
    if (!each.is_smaller && !from.origin.empty()) {
      add(each, from.origin);
      continue;
    }
    std::error_code error;
    fs::create_directories(options.cases, error);
    if (error) {
      throw UsageError("--cases: " + mesh_io::printable(options.cases) + ": " + error.message());
    }
    each.query.note = fmt::format("{}, {} {}: {} says {}, the truth is: {} ({})", findings.title,
                                  findings.place, from.where, each.engine, says,
                                  each.judgement.truth, name_of(each.judgement.error_class));
    const fs::path file =
        fs::path(options.cases) / fmt::format("{}-{}.json", each.engine, from.name);
    // What is no answer is in no file: whoever replays the case sees it again.
    Case query = each.query;
    if (each.judgement.error_class == compare::ErrorClass::EngineError) query.answer.reset();
    write_case(file, query);
    add(each, file.string());
  }
  return written;
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
  const std::vector<WrittenCase> cases = write_cases(options, field, findings);
  if (!options.report.empty()) {
    write_report(options.report, {.mesh_a = options.mesh_a,
                                  .mesh_b = options.mesh_b,
                                  .query = findings.question,
                                  .places = findings.count,
                                  .place = findings.place,
                                  .facts = facts_of(options, findings, field),
                                  .summaries = findings.summaries,
                                  .wrong = findings.wrong,
                                  .cases = cases});
  }
  const Regression regression = regression_of(options, findings);
  const std::string text =
      options.is_json ? findings.json + summary_json(findings.summaries, cases, findings.place)
                      : text_of(findings, cases, engines);
  output.write(text + regression.text);
  const bool is_bad = is_graze_wrong(findings.wrong) || regression.is_one;
  return is_bad ? ExitCode::GrazeWrong : ExitCode::Answered;
}

}  // namespace graze::cli
