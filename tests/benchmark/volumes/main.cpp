// What the fit of a volume is worth: for each bounding volume what it costs to make, how much empty
// space it holds level by level, how many false candidates it lets through, and what queries take.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/load_mesh.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/benchmark/common/pose_regimes.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/volumes/measure_queries.h"
#include "tests/benchmark/volumes/measure_skins.h"

namespace graze::benchmark {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string data;
  std::vector<std::pair<std::string, std::string>> pairs;
  std::string output;
  std::size_t poses = 60;
  int repetitions = 5;
};

/// The bundled meshes, closed and open, smooth and sharp.
const std::vector<std::pair<std::string, std::string>> kBundledPairs{{"bolt.obj", "nut.stl"},
                                                                     {"gear.ply", "pinion.off"},
                                                                     {"link.ply", "link.ply"},
                                                                     {"rock.ply", "rock.ply"},
                                                                     {"rock.ply", "terrain.ply"}};

std::string stem_of(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

Json to_json(const SkinMeasure& skin, const SkinMeasure& boxes) {
  Json levels = Json::array();
  for (std::size_t i = 0; i < skin.levels.size(); ++i) {
    const double of_boxes = boxes.levels[i].volume;
    levels.push_back({{"nodes", skin.levels[i].nodes},
                      {"volume", skin.levels[i].volume},
                      {"volume_to_aabbs",
                       of_boxes > 0 ? Json(skin.levels[i].volume / of_boxes) : Json(nullptr)}});
  }
  return {{"volume", graze::name_of(skin.volume)},
          {"build_milliseconds", skin.build_milliseconds},
          {"bytes", skin.bytes},
          {"levels", std::move(levels)}};
}

Json to_json(const Work& work, double poses) {
  return {{"volume_tests", static_cast<double>(work.volume_tests) / poses},
          {"triangle_tests", static_cast<double>(work.triangle_tests) / poses},
          {"exact_tests", static_cast<double>(work.exact_tests) / poses}};
}

Json to_json(const QueryMeasure& measure, std::size_t poses) {
  const double count = static_cast<double>(poses);
  Json any = to_json(measure.any, count);
  any["microseconds"] = measure.any_microseconds;
  Json pairs = to_json(measure.pairs, count);
  pairs["microseconds"] = measure.pairs_microseconds;
  pairs["hits"] = static_cast<double>(measure.hits) / count;
  pairs["false_share"] = measure.false_share();
  return {{"volume", measure.volume}, {"any", std::move(any)}, {"pairs", std::move(pairs)}};
}

Json measure_mesh(const std::string& file, const Options& options) {
  std::fprintf(stderr, "%s: volumes\n", stem_of(file).c_str());
  const Mesh mesh = load_mesh(file);
  Json skins = Json::array();
  const std::vector<SkinMeasure> measures = measure_skins(mesh, options.repetitions);
  for (const SkinMeasure& skin : measures)
    skins.push_back(to_json(skin, measures[0]));
  return {{"mesh", stem_of(file)},
          {"triangles", mesh.triangles().size()},
          {"volumes", std::move(skins)}};
}

void append_pair(Json& queries, const std::pair<std::string, std::string>& files,
                 const Options& options) {
  const Mesh mesh_a = load_mesh(files.first);
  const Mesh mesh_b = files.second == files.first ? mesh_a : load_mesh(files.second);
  const std::string name = stem_of(files.first) + "-" + stem_of(files.second);
  for (const Regime regime : kRegimes) {
    std::fprintf(stderr, "%s: %s", name.c_str(), name_of(regime));
    const std::vector<Pose> poses = poses_in(regime, mesh_a, mesh_b, {.count = options.poses});
    std::size_t done = 0;
    const auto on_pose = [&] {
      if (++done % 10 == 0) std::fputc('.', stderr);
    };
    Json volumes = Json::array();
    for (const QueryMeasure& measure :
         measure_queries(mesh_a, mesh_b, poses, options.repetitions, on_pose))
      volumes.push_back(to_json(measure, poses.size()));
    std::fputc('\n', stderr);
    queries.push_back({{"pair", name},
                       {"regime", name_of(regime)},
                       {"poses", poses.size()},
                       {"volumes", std::move(volumes)}});
  }
}

void run(const Options& options) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const auto& [a, b] : kBundledPairs) {
    const std::string folder = options.data + "/meshes/";
    pairs.emplace_back(folder + a, folder + b);
  }
  pairs.insert(pairs.end(), options.pairs.begin(), options.pairs.end());
  std::vector<std::string> meshes;
  for (const auto& [a, b] : pairs) {
    for (const std::string& file : {a, b}) {
      if (std::find(meshes.begin(), meshes.end(), file) == meshes.end()) meshes.push_back(file);
    }
  }
  Json result;
  result["machine"] = {{"processor", processor_name()},
                       {"threads", std::thread::hardware_concurrency()}};
  result["repetitions"] = options.repetitions;
  result["meshes"] = Json::array();
  for (const std::string& file : meshes)
    result["meshes"].push_back(measure_mesh(file, options));
  result["queries"] = Json::array();
  for (const auto& pair : pairs)
    append_pair(result["queries"], pair, options);
  std::ofstream file(options.output);
  file << result.dump(1) << "\n";
  file.close();
  if (!file) throw Error(options.output + ": cannot be written");
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  graze::benchmark::Options options;
  CLI::App program("What the fit of a bounding volume is worth: writes measurements as JSON");
  program.add_option("--data", options.data, "folder of the bundled geometry")->required();
  program.add_option("--output", options.output, "JSON file to write")->required();
  program.add_option("--pair", options.pairs, "two more meshes to measure, A B; may be repeated");
  program.add_option("--poses", options.poses, "poses in each regime (default 60)")
      ->check(CLI::Range(1, 1000000));
  program.add_option("--repetitions", options.repetitions, "runs of each query (default 5)")
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(program, argc, argv);
  try {
    graze::benchmark::run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_benchmark_volumes: %s\n", error.what());
    return 2;
  }
}
