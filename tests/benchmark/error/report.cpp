#include "tests/benchmark/error/report.h"

#include <graze/bvh/error.h>

#include <cmath>
#include <fstream>
#include <utility>

namespace graze::benchmark {
namespace {

const char* name_of(Origin origin) {
  switch (origin) {
    case Origin::Graze:
      return "graze";
    case Origin::Baseline:
      return "baseline";
    case Origin::Peer:
      break;
  }
  return "peer";
}

double two_digits(double nanoseconds) {
  return std::round(nanoseconds * 100) / 100;
}

/// Sums over the categories that `takes(category)`.
template <typename Takes>
Json summary(const QuestionResult& result, const std::vector<Score>& scores, const Takes& takes) {
  Score sum;
  std::size_t elements = 0;
  std::vector<double> times;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const CategoryFacts& category = result.categories[i];
    if (!takes(category)) continue;
    elements += category.elements;
    sum.nanoseconds += scores[i].nanoseconds * static_cast<double>(category.elements);
    sum.false_positives += scores[i].false_positives;
    sum.false_negatives += scores[i].false_negatives;
    sum.unsure += scores[i].unsure;
    sum.failed += scores[i].failed;
    times.push_back(scores[i].nanoseconds);
  }
  if (elements == 0) return nullptr;
  return {{"elements", elements},
          {"errors", sum.errors() - (result.is_one_sided ? sum.false_positives : 0)},
          {"false_positives", sum.false_positives},
          {"false_negatives", sum.false_negatives},
          {"unsure", sum.unsure},
          {"failed", sum.failed},
          {"nanoseconds_mean", two_digits(sum.nanoseconds / static_cast<double>(elements))},
          {"nanoseconds_median", two_digits(median(times))}};
}

template <typename Member>
Json column(const std::vector<Score>& scores, Member member) {
  Json values = Json::array();
  for (const Score& score : scores)
    values.push_back(member(score));
  return values;
}

Json to_row(const QuestionResult& result, const Label& label, const std::vector<Score>& scores) {
  Json row = to_json(label);
  row["all"] = summary(result, scores, [](const CategoryFacts&) { return true; });
  row["generic"] = summary(result, scores, [](const CategoryFacts& c) { return c.is_generic; });
  row["floats"] = summary(result, scores, [](const CategoryFacts& c) { return c.has_only_floats; });
  row["nanoseconds"] = column(scores, [](const Score& s) { return two_digits(s.nanoseconds); });
  row["false_positives"] = column(scores, [](const Score& s) { return s.false_positives; });
  row["false_negatives"] = column(scores, [](const Score& s) { return s.false_negatives; });
  row["unsure"] = column(scores, [](const Score& s) { return s.unsure; });
  row["failed"] = column(scores, [](const Score& s) { return s.failed; });
  return row;
}

/// Arrays of objects get a line for each; what is inside stays on it.
void write_lines(std::ostream& out, const Json& value, const std::string& indent) {
  const bool is_table = value.is_array() && !value.empty() && value[0].is_object();
  if (!is_table && !(value.is_object() && value.contains("contestants"))) {
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

Json to_json(const Label& label) {
  Json row{{"name", label.name}, {"origin", name_of(label.origin)}, {"precision", label.precision}};
  row["epsilon"] = label.epsilon ? Json(*label.epsilon) : Json(nullptr);
  return row;
}

Json to_json(const QuestionResult& result) {
  Json categories = Json::array();
  for (const CategoryFacts& category : result.categories) {
    categories.push_back({{"name", category.name},
                          {"is_generic", category.is_generic},
                          {"has_only_floats", category.has_only_floats},
                          {"elements", category.elements},
                          {"hits", category.hits},
                          {"refereed", category.refereed}});
  }
  Json contestants = Json::array();
  for (std::size_t i = 0; i < result.labels.size(); ++i)
    contestants.push_back(to_row(result, result.labels[i], result.scores[i]));
  return {{"question", result.question},
          {"is_one_sided", result.is_one_sided},
          {"repetitions", result.repetitions},
          {"categories", std::move(categories)},
          {"contestants", std::move(contestants)}};
}

void write(const Json& document, const std::string& path) {
  std::ofstream file(path);
  const char* separator = "{";
  for (const auto& [key, value] : document.items()) {
    file << separator << "\n " << Json(key).dump() << ": ";
    write_lines(file, value, " ");
    separator = ",";
  }
  file << "\n}\n";
  file.close();
  if (!file) throw Error(path + ": cannot be written");
}

}  // namespace graze::benchmark
