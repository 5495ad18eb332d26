#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/replay/case_list.h>
#include <graze/engine/cli/scoreboard/hard_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/run/advice/plain_case.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/file_bytes.h>

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

namespace graze::cli {
namespace {

namespace fs = std::filesystem;

/// Refuses anything but a name of a file of the folder: nothing may lead out of it.
void check_kind(const std::string& kind) {
  const bool is_name = !kind.empty() && std::all_of(kind.begin(), kind.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
  if (!is_name) {
    throw UsageError("--class: " + mesh_io::quoted(kind) +
                     " is no name of small letters, digits and hyphens");
  }
}

/// True if an answer is right without the tolerance that graze has near a touch: a truth has none.
bool is_true(const Case& query, const CaseAnswer& answer) {
  return compare::Judge(query).judge(answer, {"referee", ""}).verdict == compare::Verdict::Right;
}

/// Returns the case with its meshes in it, and the truth for an answer.
Case with_truth(Case query) {
  for (CaseShape* shape : {&query.a, query.b ? &*query.b : nullptr}) {
    auto* mesh = shape != nullptr ? std::get_if<CaseMesh>(shape) : nullptr;
    if (mesh != nullptr) mesh->file.reset();
  }
  if (query.answer && is_true(query, *query.answer)) {
    if (query.answered_by.engine != this_library().engine) query.answered_by = {"referee", ""};
    return query;
  }
  CaseAnswer answer = answer_case(query);
  if (query.ask == Ask::Distance && !is_true(query, answer)) {
    // The number alone is kept: no judge says which of two ways out it is.
    const std::optional<double> number = answer.distance;
    answer = {};
    answer.distance = number;
  }
  if (!is_true(query, answer)) {
    throw UsageError("--add: the referee proves no answer to it, and a hard case needs its truth");
  }
  query.answer = answer;
  query.answered_by = {this_library().engine, ""};
  return query;
}

/// Returns the case in one line, with one blank where a line ended.
std::string line_of(const Case& query) {
  std::string line;
  bool is_at_start = false;
  for (const char c : to_json(query)) {
    if (c == '\n') {
      is_at_start = true;
    } else if (!is_at_start || c != ' ') {
      const bool is_inside = !line.empty() && line.back() != '{' && line.back() != '[' && c != '}';
      if (is_at_start && is_inside) line += ' ';
      is_at_start = false;
      line += c;
    }
  }
  return compare::with_plain_numbers(line);
}

/// Returns the question alone, to tell whether two cases ask the same.
std::string question_of(Case query) {
  query.note.clear();
  query.origin.clear();
  query.answer.reset();
  query.answered_by = {};
  return to_json(query);
}

void check_new(const Case& query, const std::string& folder) {
  const std::string question = question_of(query);
  for (const fs::path& file : case_files({folder})) {
    read_listed_cases(
        file, {},
        [&](const ListedCase& each) {
          const std::string place = mesh_io::printable(each.name);
          if (each.query.note == query.note) throw UsageError("--add: " + place + " has this note");
          if (question_of(each.query) == question)
            throw UsageError("--add: " + place + " asks the same");
        },
        [](const Error& error) { throw CaseError(error.what(), error.place()); });
  }
}

/// Returns how many lines a file has; nothing if it is not there.
std::optional<std::size_t> lines_in(const fs::path& path) {
  std::ifstream file(path);
  if (!file) return std::nullopt;
  std::size_t count = 0;
  for (std::string line; std::getline(file, line);)
    ++count;
  return count;
}

}  // namespace

std::string with_counts(const std::string& page, const std::string& folder) {
  constexpr std::string_view kBegin = "| `";
  constexpr std::string_view kEnd = ".jsonl` | ";
  std::istringstream lines(page);
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t name_end = line.find(kEnd);
    const std::size_t count_end =
        name_end == line.npos ? line.npos : line.find(" |", name_end + kEnd.size());
    if (line.starts_with(kBegin) && count_end != line.npos) {
      const std::string name = line.substr(kBegin.size(), name_end - kBegin.size());
      if (const auto count = lines_in(fs::path(folder) / (name + ".jsonl"))) {
        const std::size_t from = name_end + kEnd.size();
        line.replace(from, count_end - from, std::to_string(*count));
      }
    }
    out += line + "\n";
  }
  return out;
}

void add_hard_case(const HardCaseOptions& options, Output& output) {
  check_kind(options.kind);
  Case query = read_case(options.file);
  if (!options.origin.empty()) query.origin = options.origin;
  if (!options.note.empty()) query.note = options.note;
  if (query.origin.empty()) throw UsageError("--add needs --origin: where the case is from");
  if (query.note.empty()) throw UsageError("--add needs --note: what is hard about the case");
  query = with_truth(std::move(query));
  check_new(query, options.folder);
  const fs::path file = fs::path(options.folder) / (options.kind + ".jsonl");
  const bool is_new = !fs::exists(file);
  const std::string name = mesh_io::printable(file.string());
  const std::string before = is_new ? "" : mesh_io::read_file(file, name);
  files::write_file(file, before + line_of(query) + "\n");
  output.write(fmt::format("{}: has {} cases\n", name, lines_in(file).value_or(0)));
  const fs::path readme = fs::path(options.folder) / "README.md";
  if (!fs::exists(readme)) return;
  const std::string page = mesh_io::read_file(readme, mesh_io::printable(readme.string()));
  files::write_file(readme, with_counts(page, options.folder));
  if (page.find("`" + options.kind + ".jsonl`") == page.npos) {
    output.write(fmt::format("{}: has no row for `{}.jsonl`: write one\n",
                             mesh_io::printable(readme.string()), options.kind));
  }
}

}  // namespace graze::cli
