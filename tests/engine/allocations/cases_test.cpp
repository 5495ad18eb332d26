// Cases and scenes that are read, asked, written and played while allocations fail: std::bad_alloc
// comes out, nothing is leaked, and what is asked again has the answer that it had.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/engine/allocations/fail_each_allocation.h"
#include "tests/files/temporary_directory.h"

namespace graze::tests {
namespace {

namespace fs = std::filesystem;

/// One of each question that the bundled cases ask.
std::vector<fs::path> bundled_cases() {
  std::vector<fs::path> paths;
  for (const char* name :
       {"by-hand-balls", "by-hand-boxes", "by-hand-corners-meet", "by-hand-corners-meet-distance",
        "by-hand-cubes-any", "by-hand-cubes-contacts", "by-hand-cubes-distance",
        "by-hand-cubes-pairs", "by-hand-cubes-points", "by-hand-drum-and-ball",
        "by-hand-inside-within", "by-hand-ray-beside-a-cone", "by-hand-segment", "triangle-box-01",
        "triangles-01"}) {
    paths.push_back(fs::path(GRAZE_DATA_DIR) / "regressions" / (std::string(name) + ".json"));
  }
  return paths;
}

TEST(Allocations, OfCasesThatAreReadMayFail) {
  for (const fs::path& path : bundled_cases()) {
    const std::string expected = to_json(read_case(path));
    std::string text;
    fail_each_allocation_of_files(
        path.filename().string(), [&] { text = to_json(read_case(path)); },
        [&](const Attempt&) {
          EXPECT_TRUE(to_json(read_case(path)) == expected);
          std::string().swap(text);
        },
        [&] { std::string().swap(text); });
  }
}

TEST(Allocations, OfCasesThatAreAnsweredMayFail) {
  for (const fs::path& path : bundled_cases()) {
    const std::string expected = to_json(answer_case(read_case(path)));
    const Case query = read_case(path);
    fail_each_allocation_of_files(
        path.filename().string(),
        [&] {
          const Case fresh = read_case(path);  // whose meshes have no trees yet
          static_cast<void>(answer_case(fresh));
        },
        [&](const Attempt&) { EXPECT_TRUE(to_json(answer_case(query)) == expected); });
  }
}

TEST(Allocations, OfCasesThatAreWrittenMayFail) {
  const TemporaryDirectory folder;
  const std::string path = folder.path("case.json"), old = "what was there before\n";
  const auto bytes = [&] {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  for (const fs::path& bundled : bundled_cases()) {
    const Case query = read_case(bundled);
    const std::string expected = to_json(query);
    fail_each_allocation_of_files(
        bundled.filename().string(), [&] { write_case(path, query); },
        [&](const Attempt& made) {
          EXPECT_TRUE(bytes() == (made.has_ended ? expected : old));
          EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
        },
        [&] { folder.write("case.json", old); });
  }
}

/// What is left of a scene, as far as a user sees it.
std::string seen_of(const Scene& scene) {
  std::string text = scene.note;
  for (const SceneShape& shape : scene.shapes)
    text += shape.name + name_of(shape.shape.kind());
  for (const SceneBody& body : scene.bodies)
    text += body.name + std::to_string(body.shape);
  return text + std::to_string(scene.exclusions.size());
}

std::vector<fs::path> bundled_scenes() {
  const fs::path folder = fs::path(GRAZE_DATA_DIR) / "scenes";
  return {folder / "machine.json", folder / "shapes.json"};
}

Scene bundled_scene(const fs::path& path) {
  return read_scene(path, {.mesh_folder = fs::path(GRAZE_DATA_DIR) / "meshes"});
}

TEST(Allocations, OfScenesThatAreReadMayFail) {
  for (const fs::path& path : bundled_scenes()) {
    const std::string expected = seen_of(bundled_scene(path));
    fail_each_allocation_of_files(
        path.filename().string(), [&] { static_cast<void>(bundled_scene(path)); },
        [&](const Attempt&) { EXPECT_EQ(seen_of(bundled_scene(path)), expected); });
  }
}

/// The pairs that touch after some steps.
std::vector<BodyPair> played(const Scene& scene) {
  Simulation simulation(scene);
  for (int step = 0; step < 3; ++step)
    simulation.advance();
  const auto pairs = simulation.world().pairs();
  return {pairs.begin(), pairs.end()};
}

TEST(Allocations, OfScenesThatArePlayedMayFail) {
  for (const fs::path& path : bundled_scenes()) {
    const Scene scene = bundled_scene(path);
    const std::vector<BodyPair> expected = played(scene);
    fail_each_allocation_of_files(
        path.filename().string(), [&] { static_cast<void>(played(scene)); },
        [&](const Attempt&) { EXPECT_TRUE(played(scene) == expected); });
  }
}

// A step that failed has not happened: the clock stands, and the next one is that step.
TEST(Allocations, AStepThatFailedIsTakenAgain) {
  for (const fs::path& path : bundled_scenes()) {
    const Scene scene = bundled_scene(path);
    const std::vector<BodyPair> expected = played(scene);
    const long count = allocations_of([&] { Simulation(scene).advance(); });
    for (long n = 1; n <= count; n = next_failure(n, count, 120)) {
      Simulation simulation(scene);
      for (int step = 0; step < 3; ++step) {
        if (attempt(n, [&] { simulation.advance(); }).has_ended) continue;
        EXPECT_EQ(simulation.steps(), step == 0 ? 0u : static_cast<std::size_t>(step - 1));
        simulation.advance();
      }
      const auto pairs = simulation.world().pairs();
      ASSERT_TRUE(std::vector<BodyPair>(pairs.begin(), pairs.end()) == expected) << n;
    }
  }
}

}  // namespace
}  // namespace graze::tests
