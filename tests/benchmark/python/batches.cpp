// Times of single calls and of batches in C++, for overhead.py: graze_benchmark_python BOLT NUT
// POSES COUNT

#include <graze/graze.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

template <typename Ask>
double seconds(const Ask& ask) {
  const auto began = std::chrono::steady_clock::now();
  ask();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 5) {
    std::cerr << "usage: graze_benchmark_python BOLT NUT POSES COUNT\n";
    return 2;
  }
  const graze::Mesh bolt = graze::load_mesh(arguments[1]);
  const graze::Mesh nut = graze::load_mesh(arguments[2]);
  const std::vector<graze::Pose> kinds = graze::load_poses(arguments[3]);
  const std::size_t size = std::stoul(arguments[4]);
  nlohmann::json results = nlohmann::json::array();
  for (const graze::Pose& pose : kinds) {
    constexpr int kSingles = 20000;
    int hits = 0;
    const double single = seconds([&] {
      for (int i = 0; i < kSingles; ++i)
        hits += graze::intersects({bolt}, {nut, pose});
    });
    const std::vector<graze::Pose> poses(size, pose);
    std::vector<bool> answers;
    const double batch = seconds([&] { answers = graze::intersects({bolt}, {nut, poses}); });
    results.push_back({{"single", single / kSingles},
                       {"batch", batch},
                       {"hits", std::count(answers.begin(), answers.end(), true)},
                       {"single_hits", hits}});
  }
  std::cout << results.dump() << '\n';
}
