#include <tests/benchmark/triangles/report.h>
#include <iomanip>
#include <nlohmann/json.hpp>

namespace graze::benchmark {
namespace {

nlohmann::json to_json(const std::vector<Score>& scores) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Score& score : scores) {
    rows.push_back({{"set", score.set},
                    {"contestant", score.contestant},
                    {"elements", score.elements},
                    {"hit_share", score.hit_share},
                    {"exact_share", score.exact_share},
                    {"nanoseconds", score.nanoseconds},
                    {"wrong", score.wrong}});
  }
  return rows;
}

}  // namespace

void write_table(std::ostream& stream, const std::string& title, const std::vector<Score>& scores) {
  stream << title << '\n' << std::fixed;
  std::string set;
  for (const Score& score : scores) {
    if (score.set != set) {
      set = score.set;
      stream << "\n  " << set << ": " << score.elements << " elements, " << std::setprecision(1)
             << 100 * score.hit_share << " % hits, " << 100 * score.exact_share
             << " % beyond the triage\n";
    }
    stream << std::setw(10) << std::setprecision(1) << score.nanoseconds << " ns " << std::setw(8)
           << score.wrong << " wrong   " << score.contestant << '\n';
  }
  stream << '\n';
}

void write_json(std::ostream& stream, const std::vector<Score>& pairs,
                const std::vector<Score>& boxes) {
  stream << nlohmann::json{{"pairs", to_json(pairs)}, {"boxes", to_json(boxes)}}.dump(2) << '\n';
}

}  // namespace graze::benchmark
