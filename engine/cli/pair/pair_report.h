#pragma once

#include <memory>
#include <string>

#include <graze/engine/cli/output/output.h>
#include <graze/engine/cli/pair/pair_answer.h>

namespace graze::cli {

struct PairReportSettings {
  PairQuery query = PairQuery::Pairs;
  bool is_listing = false;  ///< true to print each pair of triangles
  bool is_checked = false;  ///< true if answers carry a comparison
};

/// Prints answers as they come.
class PairReport {
 public:
  virtual ~PairReport() = default;
  virtual void begin() = 0;
  virtual void add(const PoseAnswer& answer) = 0;
  virtual void end() = 0;
};

/// Appends `,"work":{...}` to what the line holds.
void append_work(std::string& line, const Work& work);

/// Makes a report of one JSON object per line and pose.
std::unique_ptr<PairReport> make_json_report(Output& output, const PairReportSettings& settings);

/// Makes a table for people, with a summary at its end.
std::unique_ptr<PairReport> make_table_report(Output& output, const PairReportSettings& settings);

}  // namespace graze::cli
