#include <graze/bvh/error.h>
#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/compare/run/answers/answer_line.h>
#include <graze/engine/files/source.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace graze::compare {
namespace {

using cases::JsonCursor;

/// These words may stand in place of an answer.
constexpr std::array<std::string_view, 3> kNoAnswers = {"crash", "timeout", "nan"};

/// A table may have these columns, of which those of one question are there.
constexpr std::array<std::string_view, 7> kColumns = {"pose", "says", "distance", "status",
                                                      "low",  "high", "us"};

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  for (;;) {
    const std::size_t end = std::min(line.find(','), line.size());
    std::string_view cell = line.substr(0, end);
    while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t'))
      cell.remove_prefix(1);
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t' || cell.back() == '\r'))
      cell.remove_suffix(1);
    cells.emplace_back(cell);
    if (end == line.size()) return cells;
    line.remove_prefix(end + 1);
  }
}

bool is_no_answer(std::string_view word) {
  return std::find(kNoAnswers.begin(), kNoAnswers.end(), word) != kNoAnswers.end();
}

/// Returns a cell as JSON; nothing for a cell that does not suit its column. A number that is not
/// finite is no answer.
std::optional<std::string> json_of_cell(const std::string& column, const std::string& cell) {
  if (column == "status") return cases::json_string(cell);
  if (column == "says") {
    if (cell == "true" || cell == "1" || cell == "yes") return "true";
    if (cell == "false" || cell == "0" || cell == "no") return "false";
    return std::nullopt;
  }
  double number = 0;
  const char* end = cell.data() + cell.size();
  const auto [rest, error] = std::from_chars(cell.data(), end, number);
  if (error != std::errc() || rest != end || cell.empty()) return std::nullopt;
  if (column == "pose" && number == std::floor(number) && std::abs(number) < 0x1p53) {
    return std::to_string(static_cast<long long>(number));
  }
  return std::isfinite(number) ? cases::json_plain_number(number) : "\"nan\"";
}

std::string fault_named(std::string_view word) {
  if (word == "crash") return "crashed, as it is recorded";
  if (word == "timeout") return "gave no answer in time, as it is recorded";
  return "answered with no number, as it is recorded";
}

}  // namespace

std::vector<std::string> answer_columns(std::string_view line, const std::string& place) {
  std::vector<std::string> columns = cells_of(line);
  for (const std::string& column : columns) {
    const bool is_known = std::find(kColumns.begin(), kColumns.end(), column) != kColumns.end();
    if (!is_known || std::count(columns.begin(), columns.end(), column) > 1) {
      throw CaseError(place + ": " + mesh_io::quoted(column) +
                      " is no column, or stands twice; there are pose, says, distance, status, "
                      "low, high and us: lists are written as JSON lines");
    }
  }
  return columns;
}

std::string json_of_row(std::string_view row, const std::vector<std::string>& columns,
                        const std::string& place) {
  const std::vector<std::string> cells = cells_of(row);
  if (cells.size() != columns.size()) {
    throw CaseError(place + ": has " + std::to_string(cells.size()) + " cells, not " +
                    std::to_string(columns.size()));
  }
  std::string answer;
  std::string others;
  std::string_view instead;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string& column = columns[i];
    const bool is_of_answer = column != "pose" && column != "us";
    if (is_of_answer && is_no_answer(cells[i])) {
      instead = cells[i];
      continue;
    }
    if (cells[i].empty()) continue;
    const std::optional<std::string> value = json_of_cell(column, cells[i]);
    if (!value) {
      std::string message = place;
      message += ": ";
      message += mesh_io::quoted(cells[i]);
      message += " is no ";
      message += column;
      throw CaseError(message);
    }
    std::string& list = is_of_answer ? answer : others;
    list += (list.empty() ? "\"" : ",\"") + column + "\":" + *value;
  }
  std::string line = "{\"answer\":";
  line += instead.empty() ? "{" + answer + "}" : cases::json_string(instead);
  return line + (others.empty() ? "" : "," + others) + "}";
}

void check_answer_line(const JsonCursor& at, std::size_t pose) {
  at.require_keys({"pose", "answer", "us", "unsupported", "error"});
  constexpr std::int64_t kMostPoses = std::int64_t{1} << 53;
  if (at.has("pose") && at.member("pose").whole(0, kMostPoses) != static_cast<std::int64_t>(pose)) {
    at.member("pose").fail("is not " + std::to_string(pose) + ", as its line is");
  }
  const int kinds = at.has("answer") + at.has("unsupported") + at.has("error");
  if (kinds != 1) at.fail("has not one of \"answer\", \"unsupported\" and \"error\"");
  if (at.has("us")) at.member("us").number();
  if (!at.has("answer")) {
    at.member(at.has("error") ? "error" : "unsupported").text();
    return;
  }
  const JsonCursor answer = at.member("answer");
  if (!answer.is_object() && !is_no_answer(answer.text())) {
    answer.fail("is an object, or crash, timeout or nan");
  }
}

TimedAnswer heard_answer(const JsonCursor& at, const Case& query) {
  if (at.has("unsupported")) return {};
  if (at.has("error")) throw EngineFailure(mesh_io::printable(at.member("error").text()));
  const JsonCursor answer = at.member("answer");
  if (!answer.is_object()) throw EngineFailure(fault_named(answer.text()));
  try {
    const double time = at.has("us") ? std::max(at.member("us").number(), 0.0) : 0;
    return {cases::read_answer(answer, query), TimedAnswer::Time(time)};
  } catch (const CaseError& error) {
    throw EngineFailure(std::string("its answer cannot be read: ") + error.what());
  }
}

}  // namespace graze::compare
