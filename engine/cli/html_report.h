#pragma once

#include <span>
#include <string>

#include <graze/engine/cli/compare_report.h>

namespace graze::cli {

struct HtmlReportInput {
  std::string mesh_a;
  std::string mesh_b;
  std::string query;
  std::span<const compare::PoseRecord> records;
  std::span<const WrittenCase> cases;
};

/// One page that needs nothing else: no network, no script, no file. Counts, times, and for each
/// shrunk case a picture from two sides and the command that replays it.
std::string html_report(const HtmlReportInput& input);

/// The two shapes of a case as an SVG picture from two sides; empty for what has no triangles.
std::string svg_picture(const Case& query);

}  // namespace graze::cli
