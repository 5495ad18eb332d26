#include "tests/benchmark/pairs/report.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

#include "tests/benchmark/common/median.h"

namespace graze::benchmark {
namespace {

/// Four digits are more than times are worth.
double short_number(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 3);
  return std::stod(std::to_string(std::round(value / unit) * unit));
}

Json to_json(const Work& work, double poses) {
  const auto mean = [&](std::uint64_t count) {
    return short_number(static_cast<double>(count) / poses);
  };
  return {{"volume_tests", mean(work.volume_tests)},
          {"filter_tests", mean(work.filter_tests)},
          {"triangle_tests", mean(work.triangle_tests)},
          {"exact_tests", mean(work.exact_tests)}};
}

Json to_json(const Score& score) {
  const std::vector<double>& times = score.microseconds;
  const double count = static_cast<double>(times.size());
  const double sum = std::accumulate(times.begin(), times.end(), 0.0);
  Json row{{"contestant", score.contestant},
           {"question", name_of(score.question)},
           {"median_microseconds", short_number(median(times))},
           {"mean_microseconds", short_number(sum / count)},
           {"wrong", score.wrong}};
  if (score.work) row["work"] = to_json(*score.work, count);
  return row;
}

Json to_json(const RegimeResult& regime) {
  Json scores = Json::array();
  for (const Score& score : regime.scores)
    scores.push_back(to_json(score));
  return {{"regime", regime.name},     {"poses", regime.poses}, {"source", regime.source},
          {"checked", regime.checked}, {"hits", regime.hits},   {"pairs", regime.pairs},
          {"answers", scores}};
}

Json to_json(const BuildRow& build) {
  if (!build.refusal.empty())
    return {{"contestant", build.contestant}, {"left_out", build.refusal}};
  Json one_shot = Json::object();
  for (const auto& [regime, milliseconds] : build.measure.one_shot)
    one_shot[regime] = short_number(milliseconds);
  return {{"contestant", build.contestant},
          {"milliseconds", short_number(build.measure.milliseconds)},
          {"bytes", build.measure.bytes},
          {"one_shot_milliseconds", one_shot}};
}

/// Arrays of objects get a line for each; what is inside of the innermost stays on it.
void write_lines(std::ostream& out, const Json& value, const std::string& indent) {
  const bool is_table = value.is_array() && !value.empty() && value[0].is_object();
  const auto holds_table = [](const Json& item) {
    return item.is_array() && !item.empty() && item[0].is_object();
  };
  if (!is_table && !(value.is_object() && std::any_of(value.begin(), value.end(), holds_table))) {
    out << value.dump();
    return;
  }
  const char* separator = "";
  out << (is_table ? "[" : "{");
  for (const auto& [key, item] : value.items()) {
    out << separator << "\n" << indent << " ";
    if (!is_table) out << Json(key).dump() << ": ";
    write_lines(out, item, indent + " ");
    separator = ",";
  }
  out << "\n" << indent << (is_table ? "]" : "}");
}

}  // namespace

Json to_json(const SceneResult& result) {
  Json builds = Json::array();
  for (const BuildRow& build : result.builds)
    builds.push_back(to_json(build));
  Json regimes = Json::array();
  for (const RegimeResult& regime : result.regimes)
    regimes.push_back(to_json(regime));
  return {{"kind", result.kind},
          {"scene", result.name},
          {"triangles", {result.triangles_a, result.triangles_b}},
          {"mesh_bytes", result.mesh_bytes},
          {"clearance", result.clearance},
          {"builds", builds},
          {"regimes", regimes}};
}

void write(const Json& document, const std::string& path) {
  std::ofstream file(path);
  write_lines(file, document, "");
  file << "\n";
  file.close();
  if (!file) throw Error(path + ": cannot be written");
}

}  // namespace graze::benchmark
