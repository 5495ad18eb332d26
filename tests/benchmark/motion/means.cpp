#include "tests/benchmark/motion/means.h"

#include <cmath>
#include <cstdio>

namespace graze::benchmark {

using Json = nlohmann::ordered_json;

void MotionMeans::add(const std::string& question, const std::string& regime, double cold,
                      double remembering) {
  left_[question][regime].push_back(remembering / cold);
}

Json MotionMeans::to_json() const {
  Json means = left_;
  for (Json& regimes : means) {
    for (Json& shares : regimes) {
      double logarithms = 0;
      for (const Json& share : shares)
        logarithms += std::log(share.get<double>());
      const double left = std::exp(logarithms / static_cast<double>(shares.size()));
      shares = std::round(1000 * (1 - left)) / 1000;
    }
  }
  return means;
}

void MotionMeans::print() const {
  std::printf("saved in the geometric mean over scenes:\n");
  const Json means = to_json();
  for (const auto& [question, regimes] : means.items()) {
    std::printf("%-9s", question.c_str());
    for (const auto& [regime, saved] : regimes.items())
      std::printf("  %s %.0f %%", regime.c_str(), 100 * saved.get<double>());
    std::printf("\n");
  }
}

}  // namespace graze::benchmark
