#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/replay/case_list.h>
#include <graze/engine/cli/reports/table.h>
#include <graze/engine/cli/scoreboard/scoreboard.h>
#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/compare/run/shared_loads.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

namespace graze::cli {
namespace {

namespace fs = std::filesystem;
using cases::json_string;
using compare::Testimony;
using compare::Verdict;

Score score_of(const Testimony& testimony) {
  switch (testimony.judgement.verdict) {
    case Verdict::Right:
      return Score::Passed;
    case Verdict::Wrong:
      return Score::Failed;
    default:
      return Score::Unknown;
  }
}

std::size_t count_of(const Scores& scores, Score score) {
  return scores[static_cast<std::size_t>(score)];
}

/// Returns "12", or with what is not passed: "9, 2 failed, 1 refused".
std::string cell_of(const Scores& scores) {
  std::string text = std::to_string(count_of(scores, Score::Passed));
  const auto add = [&](Score score, const char* word) {
    const std::size_t count = count_of(scores, score);
    if (count > 0) text += fmt::format(", {} {}", count, word);
  };
  add(Score::Failed, "failed");
  add(Score::Refused, "refused");
  add(Score::Unknown, "unknown");
  return text;
}

std::string json_of(const Scores& scores) {
  return fmt::format("{{\"passed\":{},\"failed\":{},\"refused\":{},\"unknown\":{}}}",
                     count_of(scores, Score::Passed), count_of(scores, Score::Failed),
                     count_of(scores, Score::Refused), count_of(scores, Score::Unknown));
}

std::size_t all_of(const Scores& scores) {
  std::size_t sum = 0;
  for (const std::size_t each : scores)
    sum += each;
  return sum;
}

struct ScoredCase {
  std::string kind;
  compare::NamedCase named;
};

std::vector<ScoredCase> read_all(const std::vector<std::string>& arguments) {
  std::vector<ScoredCase> all;
  CaseMeshes meshes;
  for (const fs::path& file : case_files(arguments)) {
    const bool is_of_many = file.extension() == ".jsonl";
    const fs::path folder = fs::absolute(file).parent_path();
    const std::string kind = (is_of_many ? file.stem() : folder.filename()).string();
    read_listed_cases(
        file, {.mesh_folder = {}, .meshes = &meshes},
        [&](ListedCase each) {
          all.push_back({mesh_io::printable(kind), {std::move(each.name), std::move(each.query)}});
        },
        [](const Error& error) { throw CaseError(error.what(), error.place()); });
  }
  return all;
}

}  // namespace

Scoreboard::Scoreboard(std::span<const compare::EngineEntry> engines) {
  for (const compare::EngineEntry& entry : engines) {
    if (entry.engine == nullptr) {
      absent_.push_back(entry.name);
      continue;
    }
    names_.push_back(entry.name);
    versions_.push_back(entry.engine->name().version);
  }
}

void Scoreboard::add(const std::string& kind, const std::vector<Testimony>& testimonies) {
  std::vector<Scores>& scores = kinds_[kind];
  scores.resize(names_.size());
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const auto at =
        std::find_if(testimonies.begin(), testimonies.end(), [&](const Testimony& each) {
          return !each.is_recorded && each.witness.engine == names_[i];
        });
    const Score score = at == testimonies.end() ? Score::Refused : score_of(*at);
    ++scores[i][static_cast<std::size_t>(score)];
  }
}

Scores Scoreboard::total_of(std::size_t engine) const {
  Scores total{};
  for (const auto& [kind, scores] : kinds_)
    for (std::size_t i = 0; i < total.size(); ++i)
      total[i] += scores[engine][i];
  return total;
}

bool Scoreboard::is_graze_wrong() const {
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (names_[i] == "graze" && count_of(total_of(i), Score::Failed) > 0) return true;
  return false;
}

std::string Scoreboard::text() const {
  std::vector<Column> columns = {{"class", 14}, {"cases", 5}};
  for (std::size_t i = 0; i < names_.size(); ++i) {
    std::size_t width = std::max(names_[i].size(), cell_of(total_of(i)).size());
    for (const auto& [kind, scores] : kinds_)
      width = std::max(width, cell_of(scores[i]).size());
    columns.push_back({names_[i], width});
  }
  const Table table(columns);
  std::string out;
  for (const std::string& name : absent_)
    out += name + ": not found when this command was built\n";
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (!versions_[i].empty()) out += mesh_io::printable(names_[i] + " " + versions_[i]) + "\n";
  out += table.header();
  std::size_t cases = 0;
  const auto add = [&](const std::string& name, std::size_t count, const auto& scores_of) {
    std::vector<std::string> row = {name, std::to_string(count)};
    for (std::size_t i = 0; i < names_.size(); ++i)
      row.push_back(cell_of(scores_of(i)));
    out += table.row(row);
  };
  for (const auto& [kind, scores] : kinds_) {
    const std::size_t count = scores.empty() ? 0 : all_of(scores.front());
    cases += count;
    add(kind, count, [&, &of_kind = scores](std::size_t i) { return of_kind[i]; });
  }
  add("all", cases, [&](std::size_t i) { return total_of(i); });
  return out;
}

std::string Scoreboard::json() const {
  std::string out = "{\"engines\":[";
  for (std::size_t i = 0; i < names_.size(); ++i) {
    out +=
        fmt::format("{}{{\"engine\":{},\"version\":{},\"all\":{},\"classes\":{{", i == 0 ? "" : ",",
                    json_string(names_[i]), json_string(versions_[i]), json_of(total_of(i)));
    const char* separator = "";
    for (const auto& [kind, scores] : kinds_) {
      out += separator + json_string(kind) + ":" + json_of(scores[i]);
      separator = ",";
    }
    out += "}}";
  }
  return out + "]}\n";
}

std::string Scoreboard::markdown() const {
  std::string head = "| class |";
  std::string line = "|---|";
  for (std::size_t i = 0; i < names_.size(); ++i) {
    head += " " + mesh_io::printable(names_[i] + " " + versions_[i]) + " |";
    line += "---|";
  }
  std::string out = head + "\n" + line + "\n";
  for (const auto& [kind, scores] : kinds_) {
    out += "| " + kind + " |";
    for (const Scores& each : scores)
      out += " " + cell_of(each) + " |";
    out += "\n";
  }
  out += "| all |";
  for (std::size_t i = 0; i < names_.size(); ++i)
    out += " " + cell_of(total_of(i)) + " |";
  return out + "\n";
}

ExitCode run_scoreboard(const ScoreboardOptions& options,
                        std::span<const compare::EngineEntry> engines, Output& output) {
  const Field field(engines, options.engines);
  const std::vector<ScoredCase> cases = read_all(options.files);
  Scoreboard board(options.engines.empty() ? engines : field.engines());
  Progress progress("cases:", cases.size(), {.is_forced = options.has_progress, .has_rows = false});
  const compare::SharedLoads shared(field.engines());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    board.add(cases[i].kind, compare::try_named_case(cases[i].named, shared.engines()));
    progress.update(i + 1);
  }
  if (!options.markdown.empty()) files::write_file(options.markdown, board.markdown());
  output.write(options.is_json ? board.json() : board.text());
  return board.is_graze_wrong() ? ExitCode::GrazeWrong : ExitCode::Answered;
}

}  // namespace graze::cli
