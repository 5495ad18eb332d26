// Run time against error: contestants answer the same questions about the same hard inputs, and
// what they take stands beside how often they are wrong.

#include <graze/bvh/error.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/error/baselines/add_baselines.h"
#include "tests/benchmark/error/categories.h"
#include "tests/benchmark/error/contest.h"
#include "tests/benchmark/error/distances/distance_categories.h"
#include "tests/benchmark/error/distances/distance_contest.h"
#include "tests/benchmark/error/graze_contestants.h"
#include "tests/benchmark/error/mesh_contest.h"
#include "tests/benchmark/error/motions/motion_categories.h"
#include "tests/benchmark/error/peers/peers.h"
#include "tests/benchmark/error/report.h"
#include "tests/benchmark/error/sphere_categories.h"
#include "tests/benchmark/error/volume_categories.h"

namespace graze::benchmark {
namespace {

struct Options {
  std::string data;
  std::string output;
  Sizes sizes;
  std::size_t poses = 12;
  std::size_t distance_poses = 3;
  int repetitions = 5;
  std::vector<std::string> questions;  ///< which to ask; all if there are none
};

bool is_asked(const Options& options, const char* question) {
  const std::vector<std::string>& chosen = options.questions;
  return chosen.empty() || std::find(chosen.begin(), chosen.end(), question) != chosen.end();
}

/// Which answers can be wrong.
enum class Sides { Both, OnlyApart };

template <typename Element>
QuestionResult ask(const char* question, const Contestants<Element>& contestants,
                   std::size_t categories, Category<Element> (*make)(std::size_t, const Sizes&),
                   const Options& options) {
  QuestionResult result{question, {}, {}, {}};
  for (const auto& contestant : contestants)
    result.labels.push_back(contestant->label());
  result.scores.resize(contestants.size());
  for (std::size_t i = 0; i < categories; ++i) {
    const Category<Element> category = make(i, options.sizes);
    if (category.elements.empty()) continue;
    std::fprintf(stderr, "\r%s: %zu of %zu, %-40s", question, i + 1, categories,
                 category.name.c_str());
    const std::vector<Score> scores = contest(category, contestants, options.repetitions);
    for (std::size_t k = 0; k < scores.size(); ++k)
      result.scores[k].push_back(scores[k]);
    const auto hits = std::count(category.truth.begin(), category.truth.end(), true);
    result.categories.push_back({category.name, category.is_generic, category.has_only_floats,
                                 category.elements.size(), static_cast<std::size_t>(hits),
                                 category.refereed});
  }
  std::fputc('\n', stderr);
  return result;
}

DistanceResult ask_distances(const Contestants<TrianglePair, double>& contestants,
                             const Options& options) {
  DistanceResult result{"distance of triangles", {}, {}, {}};
  for (const auto& contestant : contestants)
    result.labels.push_back(contestant->label());
  result.scores.resize(contestants.size());
  for (std::size_t i = 0; i < distance_category_count(); ++i) {
    const DistanceCategory category = distance_category(i, options.sizes);
    std::fprintf(stderr, "\r%s: %zu of %zu, %-40s", result.question.c_str(), i + 1,
                 distance_category_count(), category.name.c_str());
    std::vector<DistanceScore> scores(contestants.size());
    const std::vector<double> times =
        take_turns(std::span<const TrianglePair>(category.elements), contestants,
                   options.repetitions, [&](std::size_t k, std::span<const double> answers) {
                     for (std::size_t n = 0; n < answers.size(); ++n)
                       count(scores[k], answers[n], category.truth[n], category.ulp[n]);
                   });
    for (std::size_t k = 0; k < scores.size(); ++k) {
      scores[k].nanoseconds = times[k];
      result.scores[k].push_back(std::move(scores[k]));
    }
    const auto touching = std::count(category.truth.begin(), category.truth.end(), 0.0);
    result.categories.push_back({category.name, category.is_generic, category.elements.size(),
                                 static_cast<std::size_t>(touching)});
  }
  std::fputc('\n', stderr);
  return result;
}

Field all_contestants() {
  Field field;
  add_graze(field);
  add_baselines(field);
  for (const Peer& peer : peers())
    peer.add(field);
  for (const std::string& name : absent_peers())
    std::fprintf(stderr, "%s was not found when this was built: left out\n", name.c_str());
  return field;
}

void ask_about_meshes_and_distances(const Field& field, const Options& options, Json& document) {
  for (QuestionResult& result : contest_of_meshes(
           field.meshes,
           {.data = options.data, .poses = options.poses, .repetitions = options.repetitions})) {
    result.repetitions = options.repetitions;
    document["questions"].push_back(to_json(result));
  }
  document["distances"].push_back(to_json(ask_distances(field.distances, options)));
  document["distances"].push_back(to_json(
      contest_of_mesh_distances(field.mesh_distances, {.data = options.data,
                                                       .poses = options.distance_poses,
                                                       .repetitions = options.repetitions})));
}

void run(const Options& options) {
  const Field field = all_contestants();
  Json document;
  document["machine"] = {{"processor", processor_name()},
                         {"threads", std::thread::hardware_concurrency()}};
  document["repetitions"] = options.repetitions;
  document["absent"] = absent_peers();
  document["questions"] = Json::array();
  const auto keep = [&](const char* question, const auto& contestants, std::size_t categories,
                        auto* make, Sides sides) {
    if (!is_asked(options, question)) return;
    QuestionResult result = ask(question, contestants, categories, make, options);
    result.is_one_sided = sides == Sides::OnlyApart;
    result.repetitions = options.repetitions;
    document["questions"].push_back(to_json(result));
  };
  keep("triangle and triangle", field.triangle_pairs, pair_category_count(), pair_category,
       Sides::Both);
  keep("triangle and box", field.triangle_boxes, box_category_count(), box_category, Sides::Both);
  keep("sphere and box", field.sphere_boxes, sphere_category_count(), sphere_box_category,
       Sides::Both);
  keep("sphere and sphere", field.sphere_pairs, sphere_category_count(), sphere_pair_category,
       Sides::Both);
  keep("point and triangle, moving", field.moving_points, motion_category_count(),
       moving_point_category, Sides::Both);
  keep("edge and edge, moving", field.moving_edges, motion_category_count(), moving_edge_category,
       Sides::Both);
  keep("box and box, oriented", field.obb_pairs, obb_category_count(), obb_category,
       Sides::OnlyApart);
  keep("k-DOP and k-DOP", field.kdop_pairs, kdop_category_count(), kdop_category, Sides::OnlyApart);
  document["distances"] = Json::array();
  if (options.questions.empty()) ask_about_meshes_and_distances(field, options, document);
  write(document, options.output);
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  graze::benchmark::Options options;
  CLI::App program("Run time against error: writes measurements as JSON");
  program.add_option("--data", options.data, "folder of the bundled geometry")->required();
  program.add_option("--output", options.output, "JSON file to write")->required();
  program.add_option("--elements", options.sizes.elements, "of each category (default 20000)")
      ->check(CLI::Range(1, 10000000));
  program
      .add_option("--refereed", options.sizes.refereed,
                  "of these, checked by the exact referee (default 400)")
      ->check(CLI::Range(1, 10000000));
  program
      .add_option("--distances", options.sizes.distances,
                  "of each category of distances (default 1000)")
      ->check(CLI::Range(1, 10000000));
  program
      .add_option("--boxes", options.sizes.boxes,
                  "of each category of oriented boxes and k-DOPs (default 4000)")
      ->check(CLI::Range(1, 10000000));
  program
      .add_option("--motions", options.sizes.motions,
                  "of each category of straight paths (default 1000)")
      ->check(CLI::Range(1, 1000000));
  program
      .add_option("--distance-poses", options.distance_poses,
                  "of meshes, from each file, for distances (default 3)")
      ->check(CLI::Range(1, 1000000));
  program.add_option("--poses", options.poses, "of meshes, from each file (default 12)")
      ->check(CLI::Range(1, 1000000));
  program.add_option("--repetitions", options.repetitions, "runs of each contestant (default 5)")
      ->check(CLI::Range(1, 1000));
  program.add_option(
      "--question", options.questions,
      "ask only this one of triangles, boxes, spheres, paths and k-DOPs, by its name "
      "in the JSON; may be repeated (default: all, and meshes and distances)");
  CLI11_PARSE(program, argc, argv);
  try {
    graze::benchmark::run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_benchmark_error: %s\n", error.what());
    return 2;
  }
}
