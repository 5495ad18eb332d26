#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/compare/advice_list.h>
#include <graze/engine/cli/compare/markup.h>
#include <graze/engine/cli/compare/shell_word.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

namespace graze::cli {
namespace {

using cases::json_string;
using compare::Advice;
using compare::AdviceStep;
using compare::WrongKind;

/// Returns the case with the fewest numbers among those of an engine that have a class.
const WrittenCase* least_case(std::span<const WrittenCase> cases, const WrongKind& kind) {
  const WrittenCase* least = nullptr;
  for (const WrittenCase& each : cases) {
    const bool is_of_kind = each.shrunk.engine == kind.engine &&
                            each.shrunk.judgement.verdict == compare::Verdict::Wrong &&
                            each.shrunk.judgement.error_class == kind.error_class;
    if (!is_of_kind) continue;
    const bool is_better =
        least == nullptr || (each.shrunk.is_smaller && !least->shrunk.is_smaller);
    if (is_better) least = &each;
  }
  return least;
}

const compare::EngineEntry* entry_of(std::span<const compare::EngineEntry> field,
                                     const std::string& engine) {
  const auto at = std::find_if(field.begin(), field.end(), [&](const compare::EngineEntry& each) {
    return each.name == engine && each.engine != nullptr;
  });
  return at == field.end() ? nullptr : &*at;
}

std::string file_name_of(const std::string& path, const char* otherwise) {
  return path.empty() ? otherwise : std::filesystem::path(path).filename().string();
}

WrongKind kind_of(const CompareOptions& options, const CompareFindings& findings,
                  const EngineSummary& summary, std::size_t at) {
  const auto error_class = compare::kErrorClasses[at];
  return {.engine = summary.engine,
          .version = "",
          .error_class = error_class,
          .count = summary.classes[at],
          .largest_error = summary.class_errors[at],
          .largest_ulps = summary.class_ulps[at],
          .tolerance = std::nullopt,
          .name_a = options.mesh_b.empty() ? "A" : file_name_of(options.mesh_a, "A"),
          .name_b = file_name_of(options.mesh_b, "B"),
          .examples = findings.wrong.examples(summary.engine, error_class)};
}

std::string heading(const Advice& advice) {
  return fmt::format("{}, {} {}", advice.engine, advice.count, advice.kind);
}

/// Returns words broken into lines of a terminal.
std::string wrapped(const std::string& words, std::size_t indent) {
  constexpr std::size_t kWidth = 100;
  std::string out;
  std::size_t column = 0;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    if (column > 0 && indent + column + 1 + (end - at) > kWidth) {
      out += "\n" + std::string(indent, ' ');
      column = 0;
    }
    out += (column > 0 ? " " : "") + words.substr(at, end - at);
    column += (column > 0 ? 1 : 0) + end - at;
    at = end + 1;
  }
  return out;
}

}  // namespace

std::vector<Advice> advice_of(const CompareOptions& options, const CompareFindings& findings,
                              std::span<const WrittenCase> cases,
                              std::span<const compare::EngineEntry> field) {
  std::vector<Advice> all;
  for (const EngineSummary& summary : findings.summaries) {
    for (std::size_t i = compare::kErrorClasses.size(); i-- > 0;) {
      if (summary.classes[i] == 0) continue;
      WrongKind kind = kind_of(options, findings, summary, i);
      if (const compare::EngineEntry* entry = entry_of(field, summary.engine)) {
        kind.version = entry->engine->name().version;
        kind.tolerance = entry->engine->tolerance();
      }
      if (const WrittenCase* least = least_case(cases, kind)) {
        kind.least = &least->shrunk;
        if (least->is_written) kind.file = shell_word(least->file);
      }
      all.push_back(advise(kind));
    }
    if (summary.not_confirmed > 0) {
      all.push_back(compare::advise_unsteady(summary.engine, summary.not_confirmed));
    }
  }
  return all;
}

std::string advice_text(std::span<const Advice> advice) {
  std::string text;
  bool has_issue = false;
  for (const Advice& each : advice) {
    text += "  " + mesh_io::printable(heading(each)) + ":\n";
    for (const AdviceStep& step : each.steps)
      text += "    " + wrapped(mesh_io::printable(step.words), 4) + "\n";
    has_issue |= !each.issue.empty();
  }
  if (text.empty()) return "";
  return "what to do:\n" + text +
         (has_issue ? "  (--report, --markdown and --json have the texts of issues)\n" : "");
}

std::string advice_json(std::span<const Advice> advice) {
  if (advice.empty()) return "";
  std::string out = "{\"advice\":[";
  for (std::size_t i = 0; i < advice.size(); ++i) {
    const Advice& each = advice[i];
    out += fmt::format("{}{{\"engine\":{},\"class\":{},\"count\":{},\"looked_at\":{},\"steps\":[",
                       i == 0 ? "" : ",", json_string(each.engine), json_string(each.kind),
                       each.count, each.looked_at);
    for (std::size_t k = 0; k < each.steps.size(); ++k) {
      out +=
          fmt::format("{}{{\"remedy\":{},\"words\":{}}}", k == 0 ? "" : ",",
                      json_string(name_of(each.steps[k].remedy)), json_string(each.steps[k].words));
    }
    out += "]";
    if (!each.issue.empty()) out += ",\"issue\":" + json_string(each.issue);
    out += "}";
  }
  return out + "]}\n";
}

std::string advice_html(std::span<const Advice> advice) {
  std::string out;
  for (const Advice& each : advice) {
    out += "<h3>" + escaped(heading(each)) + "</h3>\n<ul>\n";
    for (const AdviceStep& step : each.steps)
      out += "<li>" + escaped(step.words) + "</li>\n";
    out += "</ul>\n";
    if (each.issue.empty()) continue;
    out += "<details><summary>The text of an issue</summary><pre>" + escaped_lines(each.issue) +
           "</pre></details>\n";
  }
  return out.empty() ? "" : "<h2>What to do</h2>\n" + out;
}

std::string advice_markdown(std::span<const Advice> advice) {
  std::string out;
  for (const Advice& each : advice) {
    out += "\n**" + escaped(heading(each)) + "**\n\n";
    for (const AdviceStep& step : each.steps)
      out += "- " + escaped(step.words) + "\n";
    if (each.issue.empty()) continue;
    out += "\n<details><summary>The text of an issue</summary>\n\n<pre>" +
           escaped_lines(each.issue) + "</pre>\n\n</details>\n";
  }
  return out.empty() ? "" : "\n#### What to do\n" + out;
}

}  // namespace graze::cli
