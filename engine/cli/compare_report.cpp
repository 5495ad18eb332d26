#include <graze/engine/cases/json_text.h>
#include <graze/engine/cli/compare_report.h>
#include <graze/engine/cli/table.h>
#include <graze/engine/mesh/io/source.h>

#include <fmt/format.h>
#include <algorithm>
#include <iterator>

namespace graze::cli {
namespace {

using cases::json_number;
using cases::json_string;
using compare::AnswerRecord;
using compare::PoseRecord;
using compare::Verdict;

constexpr std::size_t kMaxRows = 40;

std::string wrong_rows(std::span<const PoseRecord> records) {
  const Table table({{"pose", 6},
                     {"engine", 8},
                     {"says", 14},
                     {"truth", 22},
                     {"why", 13},
                     {"error (m)", 10},
                     {"ulp", 9},
                     {"pairs", 6}});
  std::string rows;
  std::size_t count = 0;
  for (const PoseRecord& record : records) {
    for (const AnswerRecord& answer : record.answers) {
      if (!answer.is_wrong() || ++count > kMaxRows) continue;
      const compare::Judgement& judgement = answer.judgement;
      rows += table.row({std::to_string(record.pose), answer.engine, answer.brief, judgement.truth,
                         name_of(judgement.error_class), fmt::format("{:.3g}", judgement.error),
                         fmt::format("{:.3g}", judgement.ulps),
                         judgement.wrong_pairs == 0 ? "" : std::to_string(judgement.wrong_pairs)});
    }
  }
  if (count == 0) return "no wrong answer\n";
  std::string out = "wrong answers:\n";
  out += table.header() + rows;
  if (count > kMaxRows) out += fmt::format("... and {} more\n", count - kMaxRows);
  return out;
}

void add(EngineSummary& summary, const AnswerRecord& answer) {
  ++summary.answers;
  summary.total_time += answer.time;
  if (answer.is_agreed) {
    ++summary.agreed;
    return;
  }
  const compare::Judgement& judgement = answer.judgement;
  summary.right += judgement.verdict == Verdict::Right;
  summary.not_judged += judgement.verdict == Verdict::NotJudged;
  if (!answer.is_wrong()) return;
  ++summary.wrong;
  ++summary.classes[static_cast<std::size_t>(judgement.error_class)];
  summary.largest_error = std::max(summary.largest_error, judgement.error);
  summary.largest_ulps = std::max(summary.largest_ulps, judgement.ulps);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void Summaries::add(const AnswerRecord& answer) {
  auto at = std::find_if(summaries_.begin(), summaries_.end(), [&](const EngineSummary& summary) {
    return summary.engine == answer.engine;
  });
  if (at == summaries_.end()) {
    summaries_.push_back({.engine = answer.engine});
    times_.emplace_back();
    at = std::prev(summaries_.end());
  }
  cli::add(*at, answer);
  times_[static_cast<std::size_t>(at - summaries_.begin())].push_back(answer.time);
}

std::vector<EngineSummary> Summaries::take() const {
  std::vector<EngineSummary> summaries = summaries_;
  for (std::size_t i = 0; i < summaries.size(); ++i)
    summaries[i].median_time = median(times_[i]);
  return summaries;
}

std::vector<EngineSummary> summarise(std::span<const PoseRecord> records) {
  Summaries all;
  for (const PoseRecord& record : records) {
    for (const AnswerRecord& answer : record.answers)
      all.add(answer);
  }
  return all.take();
}

std::string compare_text(std::span<const PoseRecord> records, std::span<const WrittenCase> cases) {
  std::string out = wrong_rows(records);
  for (const WrittenCase& each : cases)
    out += "shrunk: graze replay " + mesh_io::printable(each.file) + "\n";
  return out + summary_text(summarise(records));
}

std::string summary_text(std::span<const EngineSummary> summaries) {
  const Table table({{"engine", 8},
                     {"answers", 8},
                     {"agreed", 8},
                     {"right", 7},
                     {"wrong", 7},
                     {"touching", 8},
                     {"pose rounding", 13},
                     {"degenerate", 10},
                     {"containment", 11},
                     {"real", 6},
                     {"largest (m)", 11},
                     {"median (us)", 11}});
  std::string out = table.header();
  for (const EngineSummary& s : summaries) {
    std::vector<std::string> row = {s.engine, std::to_string(s.answers), std::to_string(s.agreed),
                                    std::to_string(s.right), std::to_string(s.wrong)};
    for (const std::size_t count : s.classes)
      row.push_back(std::to_string(count));
    row.push_back(fmt::format("{:.3g}", s.largest_error));
    row.push_back(fmt::format("{:.1f}", s.median_time));
    out += table.row(row);
  }
  return out;
}

std::string summary_json(std::span<const EngineSummary> summaries,
                         std::span<const WrittenCase> cases) {
  std::string out = "{\"summary\":[";
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const EngineSummary& s = summaries[i];
    out += fmt::format(
        "{}{{\"engine\":{},\"answers\":{},\"agreed\":{},\"right\":{},\"not_judged\":{},\"wrong\":{}"
        ",\"touching\":{},\"pose_rounding\":{},\"degenerate\":{},\"containment\":{},\"real\":{}"
        ",\"largest_error\":{},\"largest_ulps\":{},\"median_us\":{:.3f},\"total_us\":{:.3f}}}",
        i == 0 ? "" : ",", json_string(s.engine), s.answers, s.agreed, s.right, s.not_judged,
        s.wrong, s.classes[0], s.classes[1], s.classes[2], s.classes[3], s.classes[4],
        json_number(s.largest_error), json_number(s.largest_ulps), s.median_time, s.total_time);
  }
  out += "],\"cases\":[";
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const WrittenCase& each = cases[i];
    out += fmt::format("{}{{\"file\":{},\"engine\":{},\"pose\":{},\"class\":{}}}",
                       i == 0 ? "" : ",", json_string(each.file), json_string(each.shrunk.engine),
                       each.shrunk.pose, json_string(name_of(each.shrunk.judgement.error_class)));
  }
  return out + "]}\n";
}

}  // namespace graze::cli
