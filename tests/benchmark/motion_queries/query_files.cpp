#include <gmpxx.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/benchmark/motion_queries/queries.h"

namespace graze::benchmark {
namespace {

struct Row {
  Eigen::Vector3d point;
  bool is_exact = true;
  bool is_hit = false;
};

Row row_of(const std::string& line) {
  std::istringstream stream(line);
  std::string field[7];
  for (std::string& text : field) {
    if (!std::getline(stream, text, ',')) throw std::runtime_error("a row of fewer than 7 numbers");
  }
  Row row;
  for (int k = 0; k < 3; ++k) {
    mpq_class exact(field[2 * k] + "/" + field[2 * k + 1]);
    exact.canonicalize();
    row.point.data()[k] = exact.get_d();
    row.is_exact &= mpq_class(row.point.data()[k]) == exact;
  }
  row.is_hit = field[6][0] == '1';
  return row;
}

void read_file(const std::filesystem::path& from, bool is_edges, MotionSet& set) {
  std::ifstream file(from);
  std::string line;
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    if (line.empty()) continue;
    rows.push_back(row_of(line));
    if (rows.size() < 8) continue;
    PointPath path[4];
    for (int i = 0; i < 4; ++i)
      path[i] = {rows[static_cast<std::size_t>(i)].point,
                 rows[static_cast<std::size_t>(i + 4)].point};
    MotionQuery query = MotionQuery::of(path, is_edges);
    if (std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.is_exact; }))
      query.is_hit = rows[0].is_hit;
    set.queries.push_back(query);
    rows.clear();
  }
}

}  // namespace

std::vector<MotionSet> sets_of_folder(const std::filesystem::path& root) {
  std::map<std::string, MotionSet> sets;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".csv") continue;
    const std::filesystem::path kind = entry.path().parent_path();
    if (kind.filename() != "edge-edge" && kind.filename() != "vertex-face") continue;
    const std::string name = kind.parent_path().filename().string();
    sets[name].name = name;
    read_file(entry.path(), kind.filename() == "edge-edge", sets[name]);
  }
  std::vector<MotionSet> result;
  for (auto& [name, set] : sets)
    result.push_back(std::move(set));
  return result;
}

}  // namespace graze::benchmark
