#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace graze::benchmark {

/// What a memory saves in the geometric mean over scenes, for each question in each regime.
class MotionMeans {
 public:
  void add(const std::string& question, const std::string& regime, double cold, double remembering);

  /// {"any": {"near": 0.6, ...}, ...}: shares of the time.
  nlohmann::ordered_json to_json() const;
  void print() const;

 private:
  nlohmann::ordered_json left_;  // lists of shares, in the same shape
};

}  // namespace graze::benchmark
