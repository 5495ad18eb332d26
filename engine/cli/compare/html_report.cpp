#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/html_report.h>
#include <graze/engine/cli/compare/markup.h>
#include <graze/engine/cli/compare/report_page.h>
#include <graze/engine/cli/compare/shell_word.h>
#include <graze/engine/cli/compare/wrong_list.h>
#include <graze/engine/cli/outlines/svg_picture.h>
#include <graze/engine/files/output_file.h>

#include <fmt/format.h>
#include <algorithm>

namespace graze::cli {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:">
<title>graze compare</title>
<style>
)";

std::string summary_table(std::span<const EngineSummary> summaries) {
  std::string out =
      "<div class=\"scroll\"><table "
      "class=\"sorted\"><tr><th>engine</th><th>answers</th><th>agreed</th><th>right</th><th>wrong</"
      "th><th>not judged</th>"
      "<th>touching</th><th>pose "
      "rounding</th><th>coplanar</th><th>degenerate</th><th>not "
      "least</th><th>containment</th><th>real</th>"
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
  return out + "</table></div>\n";
}

std::string wrong_table(const HtmlReportInput& input) {
  const std::size_t shown = std::min(input.wrong.size(), WrongList::kFirst);
  if (input.wrong.empty()) return "<p>None.</p>\n";
  std::string out = fmt::format(
      "<div class=\"scroll\"><table "
      "class=\"sorted\"><tr><th>{}</th><th>engine</th><th>says</th><th>truth</th><th>why</"
      "th><th>error, "
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
  out += "</table></div>\n";
  if (input.wrong_count > shown) {
    out += fmt::format("<p>And {} more.</p>\n", input.wrong_count - shown);
  }
  return out;
}

/// Returns a whole page as the value of an attribute in double quotes.
std::string in_attribute(const std::string& page) {
  std::string out;
  out.reserve(page.size() + page.size() / 50);
  for (const char c : page) {
    if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// Returns the size of an error as the tables have it.
std::string size_of(const compare::Judgement& judgement) {
  return fmt::format("{}, off by {:.3g} m, {:.3g} ulp", name_of(judgement.error_class),
                     judgement.error, judgement.ulps);
}

/// Returns the section of a case. It has the error in the pose that was asked about, which is that
/// of the table, and the error of what is left of it: a smaller case may be wrong by less.
std::string case_section(const HtmlReportInput& input, std::size_t number) {
  const WrittenCase& each = input.cases[number];
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
  if (number < input.viewer.first.size() && input.viewer.first[number])
    out += fmt::format("<p><button class=\"turn\" data-frame=\"{}\">Turn it</button></p>",
                       *input.viewer.first[number]);
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
  std::string out = kHead + report_css() + "</style>\n</head>\n<body>\n";
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
  if (!input.viewer.note.empty())
    out += "<p>They cannot be turned here: " + escaped(input.viewer.note) + "</p>\n";
  out += "<div class=\"cases\">\n";
  if (!input.viewer.page.empty())
    out += "<iframe id=\"viewer\" title=\"The cases, to be turned\" srcdoc=\"" +
           in_attribute(input.viewer.page) + "\"></iframe>\n";
  out += "<div class=\"list\">\n";
  for (std::size_t i = 0; i < input.cases.size(); ++i)
    out += case_section(input, i);
  return out + "</div>\n</div>\n<script>\n" + report_js() + "</script>\n</body>\n</html>\n";
}

void write_report(const std::filesystem::path& path, const HtmlReportInput& input) {
  files::write_file(path, html_report(input));
}

}  // namespace graze::cli
