// Times of single calls and of batches in C++, for overhead.py: graze_benchmark_python BOLT NUT
// POSES POINTS COUNT. POINTS are doubles, three for each of as many points and of rays to the
// origin.

#include <graze/graze.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace {

struct Seconds {
  double wall;
  double processors;  ///< of all threads together: on a busy machine the steadier of the two
};

template <typename Ask>
Seconds seconds(const Ask& ask) {
  const auto began = std::chrono::steady_clock::now();
  const std::clock_t spent = std::clock();
  ask();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(),
          static_cast<double>(std::clock() - spent) / CLOCKS_PER_SEC};
}

std::vector<Eigen::Vector3d> read_points(const char* file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(stream.tellg()) /
                                      sizeof(Eigen::Vector3d));
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(points.data()),
              static_cast<std::streamsize>(points.size() * sizeof(Eigen::Vector3d)));
  return points;
}

/// The library's batches of points and of rays from them to the origin.
nlohmann::json of_points(const graze::Mesh& bolt, const std::vector<Eigen::Vector3d>& points) {
  std::vector<graze::Ray> rays;
  for (const Eigen::Vector3d& point : points)
    rays.push_back({point, -point});
  std::vector<std::optional<graze::RayHit>> hits;
  const Seconds cast = seconds([&] { hits = graze::cast_rays({bolt}, rays); });
  std::vector<graze::NearestPoint> nearest;
  const Seconds near = seconds([&] { nearest = graze::nearest_points({bolt}, points); });
  const auto count =
      std::count_if(hits.begin(), hits.end(), [](const auto& hit) { return hit.has_value(); });
  return {{{"batch", cast.wall}, {"batch_cpu", cast.processors}, {"hits", count}},
          {{"batch", near.wall},
           {"batch_cpu", near.processors},
           {"hits", std::count_if(nearest.begin(), nearest.end(),
                                  [](const auto& point) { return point.triangle < 1000; })}}};
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 6) {
    std::cerr << "usage: graze_benchmark_python BOLT NUT POSES POINTS COUNT\n";
    return 2;
  }
  const graze::Mesh bolt = graze::load_mesh(arguments[1]);
  const graze::Mesh nut = graze::load_mesh(arguments[2]);
  const std::vector<graze::Pose> kinds = graze::load_poses(arguments[3]);
  const std::size_t size = std::stoul(arguments[5]);
  nlohmann::json results = nlohmann::json::array();
  for (const graze::Pose& pose : kinds) {
    constexpr int kSingles = 20000;
    int hits = 0;
    const Seconds single = seconds([&] {
      for (int i = 0; i < kSingles; ++i)
        hits += graze::intersects({bolt}, {nut, pose});
    });
    const std::vector<graze::Pose> poses(size, pose);
    std::vector<bool> answers;
    const Seconds batch = seconds([&] { answers = graze::intersects({bolt}, {nut, poses}); });
    results.push_back({{"single", single.wall / kSingles},
                       {"single_cpu", single.processors / kSingles},
                       {"batch", batch.wall},
                       {"batch_cpu", batch.processors},
                       {"hits", std::count(answers.begin(), answers.end(), true)},
                       {"single_hits", hits}});
  }
  for (const nlohmann::json& result : of_points(bolt, read_points(arguments[4])))
    results.push_back(result);
  std::cout << results.dump() << '\n';
}
