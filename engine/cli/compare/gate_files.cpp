#include <graze/engine/cli/compare/gate_files.h>
#include <graze/engine/cli/compare/markup.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace graze::cli {
namespace {

using compare::WrongAnswer;

/// So many wrong answers are told one by one: enough to see what goes wrong.
constexpr std::size_t kMostTold = 20;

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// "3 wrong answers: 2 real, 1 touching"
std::string by_class(const std::vector<const WrongAnswer*>& wrong) {
  std::array<std::size_t, compare::kErrorClasses.size()> counts{};
  for (const WrongAnswer* each : wrong)
    ++counts[static_cast<std::size_t>(each->answer->judgement.error_class)];
  std::string text = counted(wrong.size(), "wrong answer") + ":";
  const char* separator = " ";
  for (std::size_t i = counts.size(); i-- > 0;) {
    if (counts[i] == 0) continue;
    text += fmt::format("{}{} {}", separator, counts[i], name_of(compare::kErrorClasses[i]));
    separator = ", ";
  }
  return text;
}

std::string told(const CompareFindings& findings, const WrongAnswer& wrong) {
  const compare::Judgement& judgement = wrong.answer->judgement;
  return fmt::format("{} {}: says {}, the truth is: {} ({}, {:.3g} m)", findings.place, wrong.where,
                     wrong.answer->brief, judgement.truth, name_of(judgement.error_class),
                     judgement.error);
}

std::string subject(const CompareFindings& findings) {
  return findings.title + (findings.question.empty() ? "" : ", " + findings.question) + ", " +
         findings.count;
}

/// A cell of a table, in which a bar would begin the next one.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : escaped(text)) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

Gate::Gate(const CompareFindings& findings, const FailOn& fail_on, std::string regression)
    : regression_(std::move(regression)) {
  for (const WrongAnswer& wrong : findings.wrong) {
    const std::string& engine = wrong.answer->engine;
    const bool is_named = fail_on.matches(engine, wrong.answer->judgement);
    named_ += is_named;
    if (is_named || engine == "graze" || engine == "world") wrong_.push_back(&wrong);
  }
}

std::vector<const WrongAnswer*> Gate::wrong_of(const std::string& engine) const {
  std::vector<const WrongAnswer*> its;
  std::copy_if(wrong_.begin(), wrong_.end(), std::back_inserter(its),
               [&](const WrongAnswer* each) { return each->answer->engine == engine; });
  return its;
}

std::string junit_text(const CompareFindings& findings, const Gate& gate) {
  const std::string suite = escaped(subject(findings));
  std::size_t failures = !gate.regression().empty();
  std::string tests;
  for (const EngineSummary& summary : findings.summaries) {
    const std::vector<const WrongAnswer*> wrong = gate.wrong_of(summary.engine);
    tests += fmt::format("<testcase classname=\"graze compare\" name=\"{}\" time=\"{:.6f}\"",
                         escaped(summary.engine), summary.total_time * 1e-6);
    if (wrong.empty()) {
      tests += "/>\n";
      continue;
    }
    ++failures;
    tests += fmt::format("><failure message=\"{}\">", by_class(wrong));
    for (std::size_t i = 0; i < std::min(wrong.size(), kMostTold); ++i)
      tests += escaped(told(findings, *wrong[i])) + "\n";
    if (wrong.size() > kMostTold) tests += fmt::format("and {} more\n", wrong.size() - kMostTold);
    tests += "</failure></testcase>\n";
  }
  if (findings.difference) {
    tests += "<testcase classname=\"graze compare\" name=\"--against\"";
    tests += gate.regression().empty()
                 ? "/>\n"
                 : fmt::format("><failure message=\"a regression\">{}</failure></testcase>\n",
                               escaped(gate.regression()));
  }
  const std::size_t count = findings.summaries.size() + findings.difference.has_value();
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites><testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n"
      "{}</testsuite></testsuites>\n",
      suite, count, failures, tests);
}

std::string markdown_text(const CompareFindings& findings, const Gate& gate) {
  std::string text = fmt::format("### graze compare: {}\n\n**{}**\n\n", cell(subject(findings)),
                                 gate.is_closed() ? "failed" : "passed");
  if (!gate.regression().empty()) text += cell(gate.regression()) + "\n";
  text +=
      "| engine | answers | agreed | right | not judged | wrong | fails | largest error (m) | "
      "median (us) |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const EngineSummary& s : findings.summaries) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {:.3g} | {:.3g} |\n", cell(s.engine),
                        s.answers, s.agreed, s.right, s.not_judged, s.wrong,
                        gate.wrong_of(s.engine).size(), s.largest_error, s.median_time);
  }
  if (findings.wrong.empty()) return text;
  text += "\n| " + findings.place + " | engine | says | truth | class | error (m) |\n" +
          "|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < std::min(findings.wrong.size(), kMostTold); ++i) {
    const WrongAnswer& wrong = findings.wrong[i];
    const compare::Judgement& judgement = wrong.answer->judgement;
    text += fmt::format("| {} | {} | {} | {} | {} | {:.3g} |\n", cell(wrong.where),
                        cell(wrong.answer->engine), cell(wrong.answer->brief),
                        cell(judgement.truth), name_of(judgement.error_class), judgement.error);
  }
  if (findings.wrong.size() > kMostTold)
    text += fmt::format("\nand {} more\n", findings.wrong.size() - kMostTold);
  return text;
}

}  // namespace graze::cli
