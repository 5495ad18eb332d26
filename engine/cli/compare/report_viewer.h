#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/cli/compare/compare_report.h>

namespace graze::cli {

/// Holds a page of `graze view` that stands in a report.
struct ReportViewer {
  std::string page = {};  ///< the whole page; empty if there is none
  /// Holds for each case its first picture in that page; none if it could not be drawn.
  std::vector<std::optional<std::size_t>> first = {};
  std::string note = {};  ///< says why there is no page though there are cases; may be empty
};

/// Returns a page of some cases. Without any, or where the command was built without pages, there
/// is none. `place` is "pose", "case".
ReportViewer report_viewer(std::span<const WrittenCase> cases, const std::string& place);

}  // namespace graze::cli
