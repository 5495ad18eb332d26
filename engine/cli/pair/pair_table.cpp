#include <graze/engine/cli/pair/pair_report.h>
#include <graze/engine/cli/reports/table.h>

#include <fmt/format.h>
#include <iterator>
#include <string>
#include <vector>

namespace graze::cli {
namespace {

const char* yes_or_no(bool is_so) {
  return is_so ? "yes" : "no";
}

Table make_table(const PairReportSettings& settings) {
  std::vector<Column> columns = {{"pose", 6}, {"intersects"}};
  if (settings.query == PairQuery::Pairs) columns.push_back({"pairs", 9});
  if (settings.query == PairQuery::Distance) columns.push_back({"distance (m)", 12});
  columns.insert(columns.end(),
                 {{"volume tests"}, {"triangle tests"}, {"exact tests"}, {"time (us)", 11}});
  if (settings.is_checked)
    columns.insert(columns.end(), {{"fcl", 9}, {"graze wrong"}, {"fcl wrong"}});
  return Table(std::move(columns));
}

std::string describe(const compare::Difference& d) {
  return fmt::format("        triangles {} and {}: graze says {}, fcl says {}, truth is {}\n",
                     d.pair.a, d.pair.b, yes_or_no(d.graze_says), yes_or_no(d.fcl_says),
                     yes_or_no(d.truth));
}

class TableReport : public PairReport {
 public:
  TableReport(Output& output, const PairReportSettings& settings)
      : output_(output), settings_(settings), table_(make_table(settings)) {}

  void begin() override { output_.write(table_.header()); }

  void add(const PoseAnswer& answer) override {
    std::string text = row(answer);
    if (settings_.is_listing && answer.pairs) {
      for (const TrianglePair& pair : *answer.pairs) {
        fmt::format_to(std::back_inserter(text), "        {} {}\n", pair.a, pair.b);
      }
    }
    if (answer.fcl) {
      for (const compare::Difference& difference : answer.fcl->differences)
        text += describe(difference);
    }
    output_.write(text);
    sum(answer);
  }

  void end() override {
    std::string text = fmt::format("{} pose{}, {} intersect{}", poses_, poses_ == 1 ? "" : "s",
                                   intersecting_, intersecting_ == 1 ? "s" : "");
    if (settings_.query == PairQuery::Pairs) text += fmt::format(", {} pairs", pairs_);
    text += fmt::format(", {} tree{} built, {:.3f} ms", trees_built_, trees_built_ == 1 ? "" : "s",
                        time_.count() / 1000);
    if (settings_.is_checked) {
      text += fmt::format("; differences from fcl: graze wrong in {}, fcl wrong in {}",
                          graze_wrong_, fcl_wrong_);
    }
    output_.write(text + "\n");
  }

 private:
  std::string row(const PoseAnswer& answer) const {
    std::vector<std::string> values = {std::to_string(answer.pose), yes_or_no(answer.intersects)};
    if (answer.pairs) values.push_back(std::to_string(answer.pairs->size()));
    if (answer.gap) values.push_back(fmt::format("{:.6g}", answer.gap->distance));
    values.insert(
        values.end(),
        {std::to_string(answer.work.volume_tests), std::to_string(answer.work.triangle_tests),
         std::to_string(answer.work.exact_tests), fmt::format("{:.1f}", answer.time.count())});
    if (answer.fcl) {
      const compare::Comparison& fcl = *answer.fcl;
      values.insert(values.end(),
                    {settings_.query == PairQuery::Pairs ? std::to_string(fcl.fcl_pairs)
                                                         : yes_or_no(fcl.fcl_intersects),
                     std::to_string(fcl.graze_wrong), std::to_string(fcl.fcl_wrong)});
    }
    return table_.row(values);
  }

  void sum(const PoseAnswer& answer) {
    ++poses_;
    if (answer.intersects) ++intersecting_;
    if (answer.pairs) pairs_ += answer.pairs->size();
    trees_built_ += answer.work.trees_built;
    time_ += answer.time;
    if (!answer.fcl) return;
    graze_wrong_ += answer.fcl->graze_wrong;
    fcl_wrong_ += answer.fcl->fcl_wrong;
  }

  Output& output_;
  PairReportSettings settings_;
  Table table_;
  std::size_t poses_ = 0;
  std::size_t intersecting_ = 0;
  std::size_t pairs_ = 0;
  std::size_t trees_built_ = 0;
  std::size_t graze_wrong_ = 0;
  std::size_t fcl_wrong_ = 0;
  std::chrono::duration<double, std::micro> time_{0};
};

}  // namespace

std::unique_ptr<PairReport> make_table_report(Output& output, const PairReportSettings& settings) {
  return std::make_unique<TableReport>(output, settings);
}

}  // namespace graze::cli
