#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/benchmark/error/distances/distance_contest.h"
#include "tests/benchmark/error/report.h"

namespace graze::benchmark {
namespace {

// Law 7: a distance is off by at most 4 ulp of the largest difference of coordinates, which is at
// most twice the largest coordinate; and so is its ulp.
constexpr double kBound = 8;

double three_digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return std::strtod(text, nullptr);
}

/// The value that a share of the sorted errors does not exceed.
double quantile(const std::vector<double>& sorted, double share) {
  const auto last = static_cast<double>(sorted.size() - 1);
  return three_digits(sorted[static_cast<std::size_t>(std::ceil(share * last))]);
}

template <typename Takes>
Json summary(const DistanceResult& result, const std::vector<DistanceScore>& scores,
             const Takes& takes) {
  DistanceScore sum;
  std::size_t elements = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!takes(result.categories[i])) continue;
    elements += result.categories[i].elements;
    sum.nanoseconds += scores[i].nanoseconds * static_cast<double>(result.categories[i].elements);
    sum.errors.insert(sum.errors.end(), scores[i].errors.begin(), scores[i].errors.end());
    sum.failed += scores[i].failed;
    sum.false_zeros += scores[i].false_zeros;
    sum.false_distances += scores[i].false_distances;
  }
  if (elements == 0) return nullptr;
  std::sort(sum.errors.begin(), sum.errors.end());
  const auto beyond =
      sum.errors.end() - std::upper_bound(sum.errors.begin(), sum.errors.end(), kBound);
  Json row{{"elements", elements},
           {"beyond_bound", beyond},
           {"failed", sum.failed},
           {"false_zeros", sum.false_zeros},
           {"false_distances", sum.false_distances},
           {"nanoseconds_mean",
            std::round(sum.nanoseconds / static_cast<double>(elements) * 100) / 100}};
  for (const auto& [name, share] :
       {std::pair("ulps_median", 0.5), std::pair("ulps_99", 0.99), std::pair("ulps_max", 1.0)})
    row[name] = sum.errors.empty() ? Json(nullptr) : Json(quantile(sum.errors, share));
  return row;
}

}  // namespace

void count(DistanceScore& score, double answer, double truth, double ulp) {
  if (answer != truth && !(std::isfinite(answer) && std::isfinite(truth))) {
    ++score.failed;
    return;
  }
  score.errors.push_back(answer == truth ? 0 : std::abs(answer - truth) / ulp);
  score.false_zeros += answer == 0 && truth > 0;
  score.false_distances += answer != 0 && truth == 0;
}

Json to_json(const DistanceResult& result) {
  Json categories = Json::array();
  for (const DistanceFacts& category : result.categories) {
    categories.push_back({{"name", category.name},
                          {"is_generic", category.is_generic},
                          {"elements", category.elements},
                          {"touching", category.touching}});
  }
  Json contestants = Json::array();
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    Json row = to_json(result.labels[i]);
    const std::vector<DistanceScore>& scores = result.scores[i];
    row["all"] = summary(result, scores, [](const DistanceFacts&) { return true; });
    row["generic"] = summary(result, scores, [](const DistanceFacts& c) { return c.is_generic; });
    for (const char* key : {"nanoseconds", "ulps_max", "failed"})
      row[key] = Json::array();
    for (const DistanceScore& score : scores) {
      row["nanoseconds"].push_back(std::round(score.nanoseconds * 10) / 10);
      const auto largest = std::max_element(score.errors.begin(), score.errors.end());
      row["ulps_max"].push_back(largest == score.errors.end() ? Json(nullptr)
                                                              : Json(three_digits(*largest)));
      row["failed"].push_back(score.failed);
    }
    contestants.push_back(std::move(row));
  }
  return {{"question", result.question},
          {"bound_ulps", kBound},
          {"categories", std::move(categories)},
          {"contestants", std::move(contestants)}};
}

}  // namespace graze::benchmark
