// The JSON is written by hand: the values are numbers and booleans only, the order of the keys is
// promised, and lists of millions of pairs need not become trees of JSON values first.

#include <graze/engine/cli/pair/pair_report.h>

#include <fmt/format.h>
#include <iterator>
#include <string>

namespace graze::cli {
namespace {

void append_list(std::string& line, const TrianglePairs& pairs) {
  line += ",\"list\":[";
  const char* separator = "";
  for (const TrianglePair& pair : pairs) {
    fmt::format_to(std::back_inserter(line), "{}[{},{}]", separator, pair.a, pair.b);
    separator = ",";
  }
  line += "]";
}

void append_point(std::string& line, const char* name, const Eigen::Vector3d& point) {
  fmt::format_to(std::back_inserter(line), ",\"{}\":[{},{},{}]", name, point.x(), point.y(),
                 point.z());
}

void append_gap(std::string& line, const MeshDistance& gap) {
  fmt::format_to(std::back_inserter(line), ",\"distance\":{}", gap.distance);
  append_point(line, "point_a", gap.point_a);
  append_point(line, "point_b", gap.point_b);
  fmt::format_to(std::back_inserter(line), ",\"pair\":[{},{}]", gap.pair.a, gap.pair.b);
}

void append_comparison(std::string& line, const compare::Comparison& comparison, PairQuery query) {
  const auto end = std::back_inserter(line);
  fmt::format_to(end, ",\"fcl\":{{\"intersects\":{}", comparison.fcl_intersects);
  if (query == PairQuery::Pairs) fmt::format_to(end, ",\"pairs\":{}", comparison.fcl_pairs);
  line += ",\"differences\":[";
  const char* separator = "";
  for (const compare::Difference& d : comparison.differences) {
    fmt::format_to(end, "{}{{\"pair\":[{},{}],\"graze\":{},\"fcl\":{},\"truth\":{}}}", separator,
                   d.pair.a, d.pair.b, d.graze_says, d.fcl_says, d.truth);
    separator = ",";
  }
  fmt::format_to(end, "],\"graze_wrong\":{},\"fcl_wrong\":{}}}", comparison.graze_wrong,
                 comparison.fcl_wrong);
}

class JsonReport : public PairReport {
 public:
  JsonReport(Output& output, const PairReportSettings& settings)
      : output_(output), settings_(settings) {}

  void begin() override {}
  void end() override {}

  void add(const PoseAnswer& answer) override {
    std::string line =
        fmt::format("{{\"pose\":{},\"intersects\":{}", answer.pose, answer.intersects);
    if (answer.pairs) {
      fmt::format_to(std::back_inserter(line), ",\"pairs\":{}", answer.pairs->size());
      if (settings_.is_listing) append_list(line, *answer.pairs);
    }
    if (answer.gap) append_gap(line, *answer.gap);
    append_work(line, answer.work);
    if (answer.fcl) append_comparison(line, *answer.fcl, settings_.query);
    output_.write(line + "}\n");
  }

 private:
  Output& output_;
  PairReportSettings settings_;
};

}  // namespace

void append_work(std::string& line, const Work& work) {
  fmt::format_to(
      std::back_inserter(line),
      ",\"work\":{{\"volume_tests\":{},\"volume_rejections\":{},\"filter_tests\":{},"
      "\"triangle_tests\":{},\"exact_tests\":{},\"points_tested\":{},\"skipped_by_memory\":{},"
      "\"trees_built\":{},\"skins_built\":{}}}",
      work.volume_tests, work.volume_rejections, work.filter_tests, work.triangle_tests,
      work.exact_tests, work.points_tested, work.skipped_by_memory, work.trees_built,
      work.skins_built);
}

std::unique_ptr<PairReport> make_json_report(Output& output, const PairReportSettings& settings) {
  return std::make_unique<JsonReport>(output, settings);
}

}  // namespace graze::cli
