// Times of single calls and of batches in C++, for overhead.py: graze_benchmark_python BOLT NUT
// POSES COUNT

#include <graze/graze.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
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
  std::cout << results.dump() << '\n';
}
