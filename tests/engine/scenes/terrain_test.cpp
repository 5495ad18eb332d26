// Height fields in scenes: what files say of them, that worlds meet them as their meshes, and what
// is refused, by its place.

#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/files/temporary_directory.h"

namespace graze {
namespace {

Shape as_mesh(const Shape& shape) {
  const auto* field = shape.as<HeightField>();
  return field == nullptr ? shape : Shape(field->mesh());
}

TEST(SceneTerrain, IsMetAsItsMesh) {
  const Scene scene = read_scene(GRAZE_DATA_DIR "/scenes/terrain.json");
  Simulation simulation(scene);
  std::set<std::pair<std::size_t, std::size_t>> met;
  for (std::size_t step = 0; step <= scene.steps; ++step) {
    simulation.advance();
    std::set<std::pair<std::size_t, std::size_t>> wanted, found;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < scene.bodies.size(); ++j) {
        const SceneBody &a = scene.bodies[i], &b = scene.bodies[j];
        if (a.kind == BodyKind::Static && b.kind == BodyKind::Static) continue;
        const Shape shape_a = as_mesh(scene.shapes[a.shape].shape);
        const Shape shape_b = as_mesh(scene.shapes[b.shape].shape);
        if (intersects({shape_a, pose_at(a, simulation.time())},
                       {shape_b, pose_at(b, simulation.time())}))
          wanted.insert({i, j});
      }
    }
    for (const BodyPair& pair : simulation.world().pairs())
      found.insert({pair.a.index, pair.b.index});
    EXPECT_EQ(found, wanted) << step;
    met.insert(found.begin(), found.end());
  }
  const std::set<std::pair<std::size_t, std::size_t>> ground{{0, 2}, {0, 3}, {1, 2}, {1, 3}};
  for (const auto& pair : ground)
    EXPECT_TRUE(met.contains(pair)) << pair.first << " " << pair.second;
  EXPECT_FALSE(met.contains({0, 4})) << "the pebble goes through the hole";
}

TEST(SceneTerrain, IsAsTheFileSays) {
  const Scene scene = read_scene(GRAZE_DATA_DIR "/scenes/terrain.json");
  const HeightField& meadow = *scene.shapes[0].shape.as<HeightField>();
  EXPECT_EQ(meadow.columns(), 8u);
  EXPECT_EQ(meadow.rows(), 6u);
  EXPECT_TRUE(meadow.is_hole(3, 2) && meadow.is_hole(4, 2) && !meadow.is_hole(2, 3));
  EXPECT_EQ(meadow.material(3, 0), 1);
  EXPECT_EQ(meadow.material(3, 2), 0);
  EXPECT_EQ(meadow.vertex(1, 2).head<2>(), Eigen::Vector2d(0.2, 0.5));
  EXPECT_DOUBLE_EQ(meadow.vertex(0, 0).z(), 0.08);
  const HeightField& dunes = *scene.shapes[1].shape.as<HeightField>();
  EXPECT_DOUBLE_EQ(dunes.vertex(0, 0).z(), 23000 * 1e-5 - 0.2);
}

class SceneTerrainFiles : public testing::Test {
 protected:
  void write(const std::string& name, const std::vector<std::uint8_t>& bytes) const {
    std::ofstream file(folder_.path() / name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  Scene scene_of(const std::string& field) const {
    return parse_scene("{\"graze_scene\": 1, \"shapes\": [{\"name\": \"f\", \"height_field\": {\n" +
                           field + "}}], \"bodies\": []}",
                       "s.json", {.mesh_folder = folder_.path()});
  }
  HeightField field_of(const std::string& field) const {
    return *scene_of(field).shapes[0].shape.as<HeightField>();
  }
  std::string error_of(const std::string& field) const {
    try {
      scene_of(field);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  }

  tests::TemporaryDirectory folder_;
};

constexpr const char* kSize = R"("columns": 2, "rows": 2, "spacing": [1, 2], )";

std::string sized(const std::string& rest) {
  return kSize + rest;
}

TEST_F(SceneTerrainFiles, AreNumbersTheLeastByteFirst) {
  write("a.r16", {1, 0, 0, 1, 255, 255, 2, 0});
  const HeightField shorts = field_of(sized(R"("file": "a.r16", "format": "uint16")"));
  EXPECT_EQ(shorts.vertex(1, 0), Eigen::Vector3d(1, 0, 256));
  EXPECT_EQ(shorts.vertex(0, 1), Eigen::Vector3d(0, 2, 65535));
  write("a.r32", {0, 0, 128, 63, 0, 0, 0, 192, 0, 0, 0, 0, 0, 0, 0, 63});  // 1, -2, 0, 0.5
  const HeightField floats = field_of(sized(R"("file": "a.r32", "format": "float32")"));
  EXPECT_EQ(floats.vertex(0, 0).z(), 1);
  EXPECT_EQ(floats.vertex(1, 0).z(), -2);
  EXPECT_EQ(floats.vertex(1, 1).z(), 0.5);
}

TEST_F(SceneTerrainFiles, AreRefusedByTheirPlace) {
  const std::string at = "s.json:2: /shapes/0/height_field";
  EXPECT_EQ(error_of(sized(R"("heights": [0, 1, 2, 3])")), "");
  EXPECT_EQ(error_of(sized(R"("height_scale": 2)")),
            "s.json:1: /shapes/0/height_field: has heights or a file, one of the two");
  EXPECT_EQ(error_of(sized(R"("heights": [0, 1, 2])")),
            at + "/heights: has 3 heights; 2 columns and 2 rows have 4");
  EXPECT_EQ(error_of(sized(R"("heights": [0, 1, 2, 1e39])")),
            at + "/heights/3: is beyond the range of float");
  EXPECT_EQ(error_of(R"("columns": 1, "rows": 2, "spacing": [1, 2], "heights": [0, 1])"),
            at + "/columns: is 1; a field has at least 2 each way");
  const std::string hole = error_of(sized(R"("heights": [0, 1, 2, 3], "holes": [[0, 1]])"));
  EXPECT_EQ(hole.substr(0, hole.find(" is ")), at + "/holes/0/1:") << hole;
  EXPECT_EQ(error_of(sized(R"("heights": [0, 1, 2, 3], "materials": [1, 2])")),
            at + "/materials: has 2 materials of cells; 2 columns and 2 rows have 1");
  EXPECT_NE(error_of(sized(R"("heights": [0, 1, 2, 3], "holes": [[0, 0]])")), "") << "all is hole";
  EXPECT_NE(error_of(sized(R"("heights": [0, 1, 2, 3], "height_scale": -1)")), "");
  EXPECT_NE(error_of(sized(R"("heights": [0, 1, 2, 3], "sha256": "00")")), "");
  EXPECT_NE(error_of(sized(R"("heights": [0, 1, 2, 3], "steepness": 1)")), "");
  EXPECT_NE(error_of(sized(R"("heights": [0, 1, 2, 3]}, "sphere": {"radius": 1)")), "");
  EXPECT_NE(error_of(sized(R"("file": "a.r16")")), "") << "no format";
  EXPECT_NE(error_of(sized(R"("file": "a.r16", "format": "png")")), "");
  EXPECT_NE(error_of(sized(R"("file": "none.r16", "format": "uint16")")), "");
  EXPECT_NE(error_of(sized(R"("file": "../a.r16", "format": "uint16")")), "");
  write("a.r16", {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(error_of(sized(R"("file": "a.r16", "format": "uint16")")),
            at + "/file: the file has 6 bytes; 2 columns and 2 rows of this format have 8");
  write("nan.r32", {0, 0, 128, 63, 0, 0, 192, 127, 0, 0, 0, 0, 0, 0, 0, 63});
  const std::string nan = error_of(sized(R"("file": "nan.r32", "format": "float32")"));
  EXPECT_NE(nan.find("/shapes/0/height_field: "), std::string::npos) << nan;
  EXPECT_NE(nan.find("column 1"), std::string::npos) << nan;
}

}  // namespace
}  // namespace graze
