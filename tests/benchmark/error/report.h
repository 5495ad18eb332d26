#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/benchmark/error/contest.h"

namespace graze::benchmark {

using Json = nlohmann::ordered_json;

/// What is known of a category once its elements are gone.
struct CategoryFacts {
  std::string name;
  bool is_generic;
  bool has_only_floats;
  std::size_t elements;
  std::size_t hits;
  std::size_t refereed;
};

/// All results of one question: scores[contestant][category].
struct QuestionResult {
  std::string question;
  std::vector<CategoryFacts> categories;
  std::vector<Label> labels;
  std::vector<std::vector<Score>> scores;
  int repetitions = 0;        ///< of which times are medians
  bool is_one_sided = false;  ///< only "apart" can be wrong: of a volume around something else
};

Json to_json(const Label& label);

Json to_json(const QuestionResult& result);

/// The document, one contestant or category a line. Throws Error if it cannot be written.
void write(const Json& document, const std::string& path);

}  // namespace graze::benchmark
