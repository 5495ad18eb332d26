// Bodies of several shapes in scenes: what files say of them, and that worlds meet their parts.

#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace graze {
namespace {

Scene bundled() {
  return read_scene(GRAZE_DATA_DIR "/scenes/parts.json");
}

/// A body of the scene, or a part of it.
struct Piece {
  std::size_t body;
  Shape shape;
  Pose pose;
  Filter filter;
};

std::vector<Piece> pieces_at(const Scene& scene, double time) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const Pose pose = pose_at(body, time);
    if (body.parts.empty())
      pieces.push_back({i, scene.shapes[body.shape].shape, pose, body.filter});
    for (const ScenePart& part : body.parts)
      pieces.push_back({i, scene.shapes[part.shape].shape, placed_part(pose, part.pose),
                        part.settings.filter.value_or(body.filter)});
  }
  return pieces;
}

TEST(SceneParts, MeetWhatTheyTouchByThemselves) {
  const Scene scene = bundled();
  Simulation simulation(scene);
  std::size_t most = 0;
  for (std::size_t step = 0; step <= scene.steps; ++step) {
    simulation.advance();
    std::set<std::pair<std::size_t, std::size_t>> wanted, found;
    const std::vector<Piece> pieces = pieces_at(scene, simulation.time());
    for (const Piece& s : pieces) {
      for (const Piece& t : pieces) {
        if (s.body >= t.body || !lets_pass(s.filter, t.filter)) continue;
        if (intersects({s.shape, s.pose}, {t.shape, t.pose})) wanted.insert({s.body, t.body});
      }
    }
    for (const BodyPair& pair : simulation.world().pairs())
      found.insert({pair.a.index, pair.b.index});
    EXPECT_EQ(found, wanted) << step;
    most = std::max(most, found.size());
  }
  EXPECT_EQ(most, 2u) << "the die on its shelf, and the tray at the upper one";
}

TEST(SceneParts, AreAsTheFileSays) {
  const Scene scene = bundled();
  const SceneBody& tray = scene.bodies[1];
  ASSERT_EQ(tray.parts.size(), 3u);
  EXPECT_EQ(scene.shapes[tray.parts[1].shape].name, "ball");
  EXPECT_EQ(tray.parts[1].settings.user_data, 7u);
  EXPECT_EQ(tray.parts[1].pose.translation(), Eigen::Vector3d(0.04, 0, 0.035));
  EXPECT_EQ(tray.parts[2].settings.filter->category, 2u);
  EXPECT_FALSE(tray.parts[0].settings.filter);
  const auto shape = body_shape(scene, tray);
  const Compound* compound = compound_of(*shape);
  ASSERT_NE(compound, nullptr);
  EXPECT_EQ(compound->settings(1).user_data, 7u);
  EXPECT_EQ(body_shape(scene, scene.bodies[2])->shape()->kind(), ShapeKind::Box);
}

std::string error_of(const std::string& body) {
  try {
    parse_scene(R"({"graze_scene": 1, "shapes": [{"name": "ball", "sphere": {"radius": 1}},
      {"name": "floor", "half_space": {"normal": [0, 0, 1]}}], "bodies": [)" +
                    body + "]}",
                "scene.json");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "none";
}

TEST(SceneParts, AreRefusedByTheirPlace) {
  EXPECT_EQ(error_of(R"({"name": "a", "parts": [{"shape": "ball"}]})"), "none");
  const auto names = [](const std::string& error, const std::string& place) {
    return error.find(place) != std::string::npos;
  };
  const std::string both =
      error_of(R"({"name": "a", "shape": "ball", "parts": [{"shape": "ball"}]})");
  EXPECT_TRUE(names(both, "one or the other")) << both;
  const std::string none = error_of(R"({"name": "a", "parts": []})");
  EXPECT_TRUE(names(none, "/bodies/0/parts")) << none;
  const std::string plane =
      error_of(R"({"name": "a", "parts": [{"shape": "ball"}, {"shape": "floor"}]})");
  EXPECT_TRUE(names(plane, "/bodies/0/parts/1") && names(plane, "half-space")) << plane;
  const std::string far = error_of(
      R"({"name": "a", "parts": [{"shape": "ball", "pose": {"position": [1e300, 0, 0]}}]})");
  EXPECT_TRUE(names(far, "/bodies/0/parts/0/pose")) << far;
  const std::string unknown = error_of(R"({"name": "a", "parts": [{"shape": "box"}]})");
  EXPECT_TRUE(names(unknown, "/bodies/0/parts/0/shape")) << unknown;
}

}  // namespace
}  // namespace graze
