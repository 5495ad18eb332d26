#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/compare_report.h>
#include <graze/engine/cli/reports/table.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace graze::cli {
namespace {

using cases::json_plain_or_infinite;
using cases::json_string;
using compare::AnswerRecord;
using compare::PlaceRecord;
using compare::Verdict;
using compare::WrongAnswer;

constexpr std::size_t kMaxRows = 40;

/// Adds an answer that somebody contradicted.
void add_judged(EngineSummary& summary, const AnswerRecord& answer) {
  const compare::Judgement& judgement = answer.judgement;
  summary.right += judgement.verdict == Verdict::Right;
  summary.not_judged += judgement.verdict == Verdict::NotJudged;
  summary.not_confirmed += judgement.verdict == Verdict::NotConfirmed;
  if (!answer.is_wrong()) return;
  ++summary.wrong;
  const auto at = static_cast<std::size_t>(judgement.error_class);
  ++summary.classes[at];
  summary.class_errors[at] = std::max(summary.class_errors[at], judgement.error);
  summary.class_ulps[at] = std::max(summary.class_ulps[at], judgement.ulps);
  summary.largest_error = std::max(summary.largest_error, judgement.error);
  summary.largest_ulps = std::max(summary.largest_ulps, judgement.ulps);
}

}  // namespace

/// Returns the engine's summary with so many answers more, which took `time` together. Valid until
/// the next call.
EngineSummary& Tally::add(const std::string& engine, std::size_t answers, double time) {
  auto at = std::find_if(engines_.begin(), engines_.end(),
                         [&](const Counted& each) { return each.summary.engine == engine; });
  if (at == engines_.end()) {
    engines_.emplace_back();
    engines_.back().summary.engine = engine;
    at = std::prev(engines_.end());
  }
  at->summary.answers += answers;
  at->summary.total_time += time;
  if (answers > 0) at->times.add(time / static_cast<double>(answers));
  return at->summary;
}

void Tally::add(const PlaceRecord& record) {
  for (const AnswerRecord& answer : record.answers) {
    EngineSummary& summary = add(answer.engine, 1, answer.time);
    if (answer.is_agreed) {
      ++summary.agreed;
    } else {
      add_judged(summary, answer);
    }
  }
}

void Tally::add(const compare::StepRecord& record) {
  for (const compare::StepAnswers& each : record.engines)
    add(each.engine, each.answers, each.time).agreed += each.answers;
  for (const compare::SceneDifference& difference : record.differences) {
    for (const AnswerRecord& answer : difference.answers) {
      if (answer.is_agreed) continue;
      EngineSummary& summary = add(answer.engine, 0, 0);
      summary.agreed -= std::min<std::size_t>(summary.agreed, 1);
      add_judged(summary, answer);
    }
  }
}

std::vector<EngineSummary> Tally::summaries() const {
  std::vector<EngineSummary> all;
  for (const Counted& each : engines_) {
    all.push_back(each.summary);
    all.back().median_time = each.times.median();
  }
  return all;
}

std::string Tally::note() const {
  std::string text;
  for (const Counted& each : engines_) {
    if (each.summary.wrong == 0) continue;
    text += fmt::format("{}{} wrong of {}", text.empty() ? "" : ", ", each.summary.wrong,
                        mesh_io::printable(each.summary.engine));
  }
  return text;
}

std::vector<WrongAnswer> wrong_answers(const PlaceRecord& record) {
  std::vector<WrongAnswer> wrong;
  const std::string number = std::to_string(record.place);
  for (const AnswerRecord& answer : record.answers) {
    if (!answer.is_wrong()) continue;
    wrong.push_back({.place = record.place,
                     .where = number,
                     .name = number,
                     .answer = std::make_shared<const AnswerRecord>(answer)});
  }
  return wrong;
}

std::string wrong_rows(std::span<const WrongAnswer> wrong, std::size_t count,
                       const std::string& place) {
  const std::size_t shown = std::min(wrong.size(), kMaxRows);
  std::size_t width = 6;
  for (std::size_t i = 0; i < shown; ++i)
    width = std::max(width, wrong[i].where.size());
  const Table table({{place, width},
                     {"engine", 8},
                     {"says", 14},
                     {"truth", 22},
                     {"why", 13},
                     {"error (m)", 10},
                     {"ulp", 9},
                     {"pairs", 6}});
  if (count == 0) return "no wrong answer\n";
  std::string out = "wrong answers:\n" + table.header();
  for (std::size_t i = 0; i < shown; ++i) {
    const AnswerRecord& answer = *wrong[i].answer;
    const compare::Judgement& judgement = answer.judgement;
    out += table.row({mesh_io::printable(wrong[i].where), answer.engine, answer.brief,
                      judgement.truth, name_of(judgement.error_class),
                      fmt::format("{:.3g}", judgement.error), fmt::format("{:.3g}", judgement.ulps),
                      judgement.wrong_pairs == 0 ? "" : std::to_string(judgement.wrong_pairs)});
  }
  if (count > shown) out += fmt::format("... and {} more\n", count - shown);
  return out;
}

std::string summary_text(std::span<const EngineSummary> summaries) {
  const Table table({{"engine", 8},
                     {"answers", 8},
                     {"agreed", 8},
                     {"right", 7},
                     {"wrong", 7},
                     {"not judged", 10},
                     {"touching", 8},
                     {"pose rounding", 13},
                     {"coplanar", 8},
                     {"degenerate", 10},
                     {"not least", 9},
                     {"containment", 11},
                     {"real", 6},
                     {"engine error", 12},
                     {"not confirmed", 13},
                     {"largest (m)", 11},
                     {"median (us)", 11}});
  std::string out = table.header();
  for (const EngineSummary& s : summaries) {
    std::vector<std::string> row = {s.engine,
                                    std::to_string(s.answers),
                                    std::to_string(s.agreed),
                                    std::to_string(s.right),
                                    std::to_string(s.wrong),
                                    std::to_string(s.not_judged)};
    for (const std::size_t count : s.classes)
      row.push_back(std::to_string(count));
    row.push_back(std::to_string(s.not_confirmed));
    row.push_back(fmt::format("{:.3g}", s.largest_error));
    row.push_back(fmt::format("{:.1f}", s.median_time));
    out += table.row(row);
  }
  return out;
}

std::string summary_json(std::span<const EngineSummary> summaries,
                         std::span<const WrittenCase> cases, const std::string& place) {
  std::string out = "{\"summary\":[";
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const EngineSummary& s = summaries[i];
    out += fmt::format(
        "{}{{\"engine\":{},\"answers\":{},\"agreed\":{},\"right\":{},\"not_judged\":{},\"wrong\":{"
        "}",
        i == 0 ? "" : ",", json_string(s.engine), s.answers, s.agreed, s.right, s.not_judged,
        s.wrong);
    for (std::size_t k = 0; k < s.classes.size(); ++k) {
      std::string key = name_of(compare::kErrorClasses[k]);
      std::replace(key.begin(), key.end(), ' ', '_');
      out += fmt::format(",\"{}\":{}", key, s.classes[k]);
    }
    out += fmt::format(
        ",\"not_confirmed\":{},\"largest_error\":{},\"largest_ulps\":{},\"median_us\":{:.3f},"
        "\"total_us\":{:.3f}}}",
        s.not_confirmed, json_plain_or_infinite(s.largest_error),
        json_plain_or_infinite(s.largest_ulps), s.median_time, s.total_time);
  }
  out += "],\"cases\":[";
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const WrittenCase& each = cases[i];
    out += fmt::format(
        "{}{{\"file\":{},\"written\":{},\"engine\":{},{}:{},\"class\":{},\"least\":{},\"stopped\":{"
        "}}}",
        i == 0 ? "" : ",", json_string(each.file), each.is_written, json_string(each.shrunk.engine),
        json_string(place), each.place, json_string(name_of(each.shrunk.judgement.error_class)),
        !each.least.empty(), each.shrunk.is_stopped);
  }
  return out + "]}\n";
}

}  // namespace graze::cli
