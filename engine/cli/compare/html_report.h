#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/cli/compare/compare_report.h>
#include <graze/engine/cli/compare/report_viewer.h>

namespace graze::cli {

/// Holds one of the things that the page says of the run: "seed", "7".
struct ReportFact {
  std::string name;
  std::string value;
};

struct HtmlReportInput {
  std::string mesh_a;  ///< a mesh, or a scene, or a folder
  std::string mesh_b;  ///< empty for a scene and a folder
  std::string query;   ///< empty if each case says it
  std::string places;  ///< "12 poses"
  std::string place;   ///< "pose"
  std::vector<ReportFact> facts = {};
  std::span<const EngineSummary> summaries;
  std::span<const compare::WrongAnswer> wrong;  ///< wrong answers, of which the first are shown
  std::size_t wrong_count = 0;  ///< the number of wrong answers, of which these are some
  std::span<const WrittenCase> cases;
  std::string advice = {};   ///< a section as advice_html() makes it
  ReportViewer viewer = {};  ///< the viewer of the cases
};

/// Returns one page that needs no network and no other file. It has counts, times, and for each
/// shrunk case a still from two sides and the command that replays it; beside them stands a viewer
/// where these can be turned. Its script sorts and filters tables and leads to cases; all is there
/// without it, too.
std::string html_report(const HtmlReportInput& input);

/// Writes the page to a file. Throws FileError if that cannot be done.
void write_report(const std::filesystem::path& path, const HtmlReportInput& input);

}  // namespace graze::cli
