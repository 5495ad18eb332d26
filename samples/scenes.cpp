// One scene of stacks, planks, stairs, wheels or gears, and what the solver makes of it.
// scenes DATA_DIR [NAME [--large] [--gltf FILE]]: without a name it lists them.
// Exits with 1 if what must rest does not, or something gains energy or flies.

#include <graze/graze.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "samples/simulation/gltf_writer.h"
#include "samples/simulation/scenes/catalogue.h"
#include "samples/simulation/scenes/judgement.h"
#include "samples/simulation/solid_meshes.h"

namespace {

using namespace graze::samples;

constexpr double kFramesPerSecond = 30;  // of the animation
constexpr double kLinesPerSecond = 4;    // of what is printed
constexpr const char* kUsage = "usage: scenes DATA_DIR [NAME [--large] [--gltf FILE]]\n";

struct Options {
  std::string name, gltf;
  CatalogueSettings catalogue;
};

std::optional<Options> options_of(int argc, char** argv) {
  if (argc < 2) return std::nullopt;
  Options options;
  options.catalogue.data = argv[1];
  if (argc > 2) options.name = argv[2];
  for (int i = 3; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--large") {
      options.catalogue.extent = Extent::Large;
    } else if (word == "--gltf" && i + 1 < argc) {
      options.gltf = argv[++i];
    } else {
      return std::nullopt;
    }
  }
  return options;
}

/// Poses by time, for the animation.
class Film {
 public:
  explicit Film(const Scene& scene) : scene_(scene), poses_(scene.bodies.size()) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      poses_[i].push_back(scene.bodies[i].pose);
    times_.push_back(0);
  }

  void look(const SceneRun& run) {
    if (run.time() * kFramesPerSecond < static_cast<double>(times_.size())) return;
    times_.push_back(run.time());
    for (std::size_t i = 0; i < poses_.size(); ++i)
      poses_[i].push_back(run.bodies()[i].pose());
  }

  void write(const std::string& path) const {
    GltfScene file{.shapes = {}, .bodies = {}, .times = times_};
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const SceneBody& body = scene_.bodies[i];
      const graze::Mesh* mesh = body.shape.as<graze::Mesh>();
      const bool is_fixed = body.hold == Hold::Fixed;
      file.shapes.push_back(
          {body.name, mesh ? *mesh : surface_of(body.shape), colour(i, is_fixed)});
      file.bodies.push_back({i, is_fixed ? std::vector{body.pose} : poses_[i]});
    }
    write_gltf(path, file);
  }

 private:
  static std::array<double, 3> colour(std::size_t index, bool is_fixed) {
    if (is_fixed) return {0.2, 0.22, 0.25};
    return index % 2 == 0 ? std::array{0.6, 0.35, 0.15} : std::array{0.3, 0.35, 0.45};
  }

  const Scene& scene_;
  std::vector<std::vector<graze::Pose>> poses_;
  std::vector<double> times_;
};

/// The one of which a line tells: the last that moves.
std::size_t told_of(const Scene& scene) {
  std::size_t last = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].hold != Hold::Fixed) last = i;
  }
  return last;
}

int run(const Options& options) {
  const std::optional<Scene> scene = find_scene(options.name, options.catalogue);
  if (!scene) {
    std::fprintf(stderr, "scenes: there is no scene '%s'\n", options.name.c_str());
    return 2;
  }
  Film film(*scene);
  const std::size_t told = told_of(*scene);
  std::printf("%zu bodies, %d steps; of %s:\n", scene->bodies.size(), scene->steps,
              scene->bodies[told].name.c_str());
  std::printf(
      "  second   energy, J  contacts  deepest, mm        x, m        y, m        z, m  spin, "
      "rad/s\n");
  int lines = 0;
  const SceneReport report = run_scene(*scene, [&](const SceneRun& run) {
    film.look(run);
    if (run.time() * kLinesPerSecond < lines + 1 && run.steps() < scene->steps) return;
    ++lines;
    const RigidBody& body = run.bodies()[told];
    std::printf("%8.2f  %10.5g  %8zu  %11.4f  %10.5f  %10.5f  %10.5f  %11.4f\n", run.time(),
                run.energy(), run.contact_count(), 1e3 * run.depth(), body.at.x(), body.at.y(),
                body.at.z(), body.spin.norm());
  });
  std::printf("in the last quarter: drift %.3g mm, speed %.3g mm/s, deepest contact %.3g mm\n",
              1e3 * report.drift, 1e3 * report.speed, 1e3 * report.depth);
  std::printf("contacts took %.2f s of one core, the solver %.2f s\n", report.world_seconds,
              report.solver_seconds);
  const std::vector<std::string> wrong = complaints(report, scene->outcome);
  for (const std::string& complaint : wrong)
    std::printf("WRONG: %s\n", complaint.c_str());
  if (wrong.empty()) {
    std::printf("%s: %s\n", scene->outcome == Outcome::Shown ? "only shown" : "as it must be",
                scene->name.c_str());
  }
  if (!options.gltf.empty()) film.write(options.gltf);
  return wrong.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<Options> options = options_of(argc, argv);
  if (!options) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  try {
    if (!options->name.empty()) return run(*options);
    for (const Scene& scene : all_scenes(options->catalogue))
      std::printf("%s\n", scene.name.c_str());
    return 0;
  } catch (const graze::Error& error) {
    std::fprintf(stderr, "scenes: %s\n", error.what());
    return 1;
  }
}
