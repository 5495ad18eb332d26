#include <graze/engine/cli/compare/advice_list.h>
#include <graze/engine/cli/compare/gate_files.h>
#include <graze/engine/cli/compare/markup.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <utility>

namespace graze::cli {
namespace {

using compare::WrongAnswer;

/// So many wrong answers are told one by one, enough to see what goes wrong.
constexpr std::size_t kMostTold = WrongList::kFirstOfEngine;

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Returns "3 wrong answers: 2 real, 1 touching".
std::string by_class(const WrongList::Closing& closing) {
  std::string text = counted(closing.count, "wrong answer") + ":";
  const char* separator = " ";
  for (std::size_t i = closing.classes.size(); i-- > 0;) {
    if (closing.classes[i] == 0) continue;
    text +=
        fmt::format("{}{} {}", separator, closing.classes[i], name_of(compare::kErrorClasses[i]));
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

/// Returns a cell of a table, in which a bar would begin the next one.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : escaped(text)) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

std::string junit_text(const CompareFindings& findings, const Gate& gate) {
  const std::string suite = escaped(subject(findings));
  std::size_t failures = !gate.regression.empty();
  std::string tests;
  for (const EngineSummary& summary : findings.summaries) {
    const WrongList::Closing& closing = findings.wrong.closing(summary.engine);
    tests += fmt::format("<testcase classname=\"graze compare\" name=\"{}\" time=\"{:.6f}\"",
                         escaped(summary.engine), summary.total_time * 1e-6);
    if (closing.count == 0) {
      tests += "/>\n";
      continue;
    }
    ++failures;
    tests += fmt::format("><failure message=\"{}\">", by_class(closing));
    for (const WrongAnswer& wrong : closing.first)
      tests += escaped(told(findings, wrong)) + "\n";
    if (closing.count > closing.first.size())
      tests += fmt::format("and {} more\n", closing.count - closing.first.size());
    tests += "</failure></testcase>\n";
  }
  if (findings.changes) {
    tests += "<testcase classname=\"graze compare\" name=\"--against\"";
    tests += gate.regression.empty()
                 ? "/>\n"
                 : fmt::format("><failure message=\"a regression\">{}</failure></testcase>\n",
                               escaped(gate.regression));
  }
  const std::size_t count = findings.summaries.size() + findings.changes.has_value();
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites><testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n"
      "{}</testsuite></testsuites>\n",
      suite, count, failures, tests);
}

std::string markdown_text(const CompareFindings& findings, const Gate& gate,
                          std::span<const compare::Advice> advice) {
  std::string text = fmt::format("### graze compare: {}\n\n**{}**\n\n", cell(subject(findings)),
                                 gate.is_closed ? "failed" : "passed");
  if (!gate.regression.empty()) text += cell(gate.regression) + "\n";
  text +=
      "| engine | answers | agreed | right | not judged | wrong | fails | largest error (m) | "
      "median (us) |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const EngineSummary& s : findings.summaries) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {:.3g} | {:.3g} |\n", cell(s.engine),
                        s.answers, s.agreed, s.right, s.not_judged, s.wrong,
                        findings.wrong.closing(s.engine).count, s.largest_error, s.median_time);
  }
  if (findings.wrong.count() == 0) return text + advice_markdown(advice);
  text += "\n| " + findings.place + " | engine | says | truth | class | error (m) |\n" +
          "|---|---|---|---|---|---|\n";
  const std::vector<WrongAnswer> list = findings.wrong.kept();
  const std::size_t shown = std::min(list.size(), kMostTold);
  for (std::size_t i = 0; i < shown; ++i) {
    const WrongAnswer& wrong = list[i];
    const compare::Judgement& judgement = wrong.answer->judgement;
    text += fmt::format("| {} | {} | {} | {} | {} | {:.3g} |\n", cell(wrong.where),
                        cell(wrong.answer->engine), cell(wrong.answer->brief),
                        cell(judgement.truth), name_of(judgement.error_class), judgement.error);
  }
  if (findings.wrong.count() > shown)
    text += fmt::format("\nand {} more\n", findings.wrong.count() - shown);
  return text + advice_markdown(advice);
}

}  // namespace graze::cli
