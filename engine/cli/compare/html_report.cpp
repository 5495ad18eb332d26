#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/html_report.h>
#include <graze/engine/cli/compare/markup.h>
#include <graze/engine/cli/compare/shell_word.h>
#include <graze/engine/cli/compare/wrong_list.h>
#include <graze/engine/files/output_file.h>

#include <fmt/format.h>
#include <algorithm>

namespace graze::cli {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>graze compare</title>
<style>
body { font: 15px/1.5 sans-serif; margin: 2em auto; max-width: 68em; padding: 0 1em; color: #222; }
table { border-collapse: collapse; margin: 1em 0; }
th, td { padding: 0.2em 0.8em; text-align: right; border-bottom: 1px solid #ddd; }
th:first-child, td:first-child { text-align: left; }
.case { display: flex; gap: 1.5em; flex-wrap: wrap; border-top: 1px solid #ddd; padding: 1em 0; }
.facts th { text-align: left; font-weight: normal; color: #666; }
.facts td { text-align: left; overflow-wrap: anywhere; }
svg text { font: 11px sans-serif; fill: #444; }
.bar { fill: none; stroke: #444; }
.view { fill: #fafafa; stroke: #ccc; }
.a { color: #1f6fb4; } .b { color: #d95f02; } .bad { color: #b00; font-weight: bold; }
pre { background: #f2f2f2; padding: 0.5em 1em; white-space: pre-wrap; overflow-wrap: anywhere; }
code { background: #f2f2f2; padding: 0.1em 0.4em; overflow-wrap: anywhere; }
</style>
</head>
<body>
)";

std::string summary_table(std::span<const EngineSummary> summaries) {
  std::string out =
      "<table><tr><th>engine</th><th>answers</th><th>agreed</th><th>right</th><th>wrong</"
      "th><th>not judged</th>"
      "<th>touching</th><th>pose "
      "rounding</th><th>coplanar</th><th>degenerate</th><th>containment</th><th>real</th>"
      "<th>engine error</th><th>not confirmed</th><th>largest error, m</th><th>in "
      "ulp</th><th>median, us</th><th>total, "
      "ms</th></tr>\n";
  for (const EngineSummary& s : summaries) {
    out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td{}>{}</td><td>{}</td>",
                       escaped(s.engine), s.answers, s.agreed, s.right,
                       s.wrong == 0 ? "" : " class=\"bad\"", s.wrong, s.not_judged);
    for (const std::size_t count : s.classes)
      out += fmt::format("<td>{}</td>", count);
    out += fmt::format(
        "<td>{}</td><td>{:.3g}</td><td>{:.3g}</td><td>{:.1f}</td><td>{:.2f}</td></tr>\n",
        s.not_confirmed, s.largest_error, s.largest_ulps, s.median_time, s.total_time / 1000);
  }
  return out + "</table>\n";
}

std::string wrong_table(const HtmlReportInput& input) {
  const std::size_t shown = std::min(input.wrong.size(), WrongList::kFirst);
  if (input.wrong.empty()) return "<p>None.</p>\n";
  std::string out = fmt::format(
      "<table><tr><th>{}</th><th>engine</th><th>says</th><th>truth</th><th>why</th><th>error, "
      "m</th><th>in ulp</th></tr>\n",
      input.place);
  for (std::size_t i = 0; i < shown; ++i) {
    const compare::AnswerRecord& answer = *input.wrong[i].answer;
    const compare::Judgement& judgement = answer.judgement;
    out += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.3g}</td><td>{:.3g}</td>"
        "</tr>\n",
        escaped(input.wrong[i].where), escaped(answer.engine), escaped(answer.brief),
        escaped(judgement.truth), name_of(judgement.error_class), judgement.error, judgement.ulps);
  }
  out += "</table>\n";
  if (input.wrong_count > shown) {
    out += fmt::format("<p>And {} more.</p>\n", input.wrong_count - shown);
  }
  return out;
}

/// The size of an error as the tables have it.
std::string size_of(const compare::Judgement& judgement) {
  return fmt::format("{}, off by {:.3g} m, {:.3g} ulp", name_of(judgement.error_class),
                     judgement.error, judgement.ulps);
}

/// The error in the pose that was asked about, which is that of the table, and that of what is left
/// of it: a smaller case may be wrong by less.
std::string case_section(const HtmlReportInput& input, const WrittenCase& each) {
  const compare::ShrunkCase& shrunk = each.shrunk;
  const std::string picture = svg_picture(shrunk.query);
  const std::string engine = escaped(shrunk.engine);
  std::string out = fmt::format(
      "<div class=\"case\"><div>{}</div><div><h3>{} in {} {}</h3>",
      picture.empty() ? "no picture: its numbers are beyond what can be drawn" : picture, engine,
      input.place, escaped(each.where));
  if (shrunk.wrong < input.wrong.size()) {
    const compare::AnswerRecord& answer = *input.wrong[shrunk.wrong].answer;
    out += fmt::format("<p>As it was asked: {} says <b>{}</b>, the truth is <b>{}</b>: {}.</p>",
                       engine, escaped(answer.brief), escaped(answer.judgement.truth),
                       size_of(answer.judgement));
  }
  out += fmt::format("<p>{}: {} says <b>{}</b>, the truth is <b>{}</b>: {}.{}</p>",
                     shrunk.is_smaller ? "Shrunk, as in the picture" : "In the picture", engine,
                     each.says.empty() ? "nothing" : escaped(each.says),
                     escaped(shrunk.judgement.truth), size_of(shrunk.judgement),
                     each.least.empty() ? "" : std::string(" It ") + escaped(each.least) + ".");
  if (shrunk.is_stopped) out += "<p>The time for shrinking was over before its end.</p>";
  if (!each.is_written) return out + "<p>It could not be written.</p></div></div>\n";
  return out + fmt::format("<p><code>graze replay {}</code></p></div></div>\n",
                           escaped(shell_word(each.file)));
}

std::string facts_table(std::span<const ReportFact> facts) {
  if (facts.empty()) return "";
  std::string out = "<table class=\"facts\">";
  for (const ReportFact& fact : facts) {
    out +=
        fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", escaped(fact.name), escaped(fact.value));
  }
  return out + "</table>\n";
}

}  // namespace

std::string html_report(const HtmlReportInput& input) {
  std::string out = kHead;
  out +=
      fmt::format("<h1>graze compare</h1>\n<p><span class=\"a\">{}</span>", escaped(input.mesh_a));
  if (!input.mesh_b.empty()) {
    out += fmt::format(" and <span class=\"b\">{}</span>", escaped(input.mesh_b));
  }
  if (!input.query.empty()) out += fmt::format(", question <b>{}</b>", escaped(input.query));
  out += fmt::format(
      ", {}. Where engines differ, a referee in exact arithmetic decides; "
      "<i>agreed</i> are answers that nobody contradicted.</p>\n",
      input.places);
  out += facts_table(input.facts);
  out += summary_table(input.summaries);
  out += input.advice;
  out += "<h2>Wrong answers</h2>\n" + wrong_table(input);
  out += "<h2>Wrong answers, shrunk</h2>\n";
  if (input.cases.empty()) out += "<p>None.</p>\n";
  for (const WrittenCase& each : input.cases)
    out += case_section(input, each);
  return out + "</body>\n</html>\n";
}

void write_report(const std::filesystem::path& path, const HtmlReportInput& input) {
  files::write_file(path, html_report(input));
}

}  // namespace graze::cli
