// Files that are no scenes are refused by one line that names the file and the place.

#include <graze/engine/cases/read_case.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/scenes/read_scene.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <string>

#include "tests/files/temporary_directory.h"

namespace graze {
namespace {

constexpr const char* kMesh = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

class HostileScene : public testing::Test {
 protected:
  std::string error_of(const std::string& text) const {
    try {
      parse_scene(text, "s.json", {.mesh_folder = folder_.path()});
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  }

  /// On line 2 a shape, on line 3 a body with more members.
  static std::string with(const std::string& shape, const std::string& members,
                          const std::string& rest = "") {
    return "{\"graze_scene\": 1, \"shapes\": [\n{\"name\": \"s\", " + shape +
           "}], \"bodies\": [\n{\"name\": \"b\", \"shape\": \"s\"" + members + "}]" + rest + "}";
  }
  static std::string with_shape(const std::string& shape) { return with(shape, ""); }
  static std::string with_body(const std::string& members, const std::string& rest = "") {
    return with("\"sphere\": {\"radius\": 1}", members, rest);
  }
  static std::string with_mesh(const std::string& file) {
    return with_shape("\"mesh\": {\"file\": \"" + file + "\"}");
  }

  tests::TemporaryDirectory folder_;
};

TEST_F(HostileScene, TheHarmlessOneIsRead) {
  EXPECT_EQ(error_of(with_body("")), "");
  EXPECT_EQ(error_of("{\"graze_scene\": 1, \"shapes\": [], \"bodies\": []}"), "");
}

TEST_F(HostileScene, WhatIsNoJson) {
  EXPECT_EQ(error_of("").substr(0, 19), "s.json:1: not JSON:");
  EXPECT_EQ(error_of("{\"graze_scene\": 1,\n\n]").substr(0, 19), "s.json:3: not JSON:");
  EXPECT_EQ(error_of("[NaN]").substr(0, 23), "s.json:1: /0: not JSON:");
  EXPECT_EQ(error_of(std::string(1000000, '[')), "s.json:1: nested deeper than 32 levels");
}

TEST_F(HostileScene, KeysAndTypes) {
  EXPECT_EQ(error_of("[]"), "s.json:1: is an array, not an object");
  EXPECT_EQ(error_of("{\"graze_scene\": 1}"), "s.json:1: has no \"shapes\"");
  EXPECT_EQ(error_of("{\"graze_scene\": 2}"),
            "s.json:1: /graze_scene: is version 2; this program reads 1");
  EXPECT_EQ(error_of("{\"graze_case\": 1}").substr(0, 35), "s.json:1: unknown key \"graze_case\";");
  EXPECT_EQ(error_of("{\"graze_scene\": 1, \"shapes\": {}, \"bodies\": []}"),
            "s.json:1: /shapes: is an object, not an array");
  EXPECT_EQ(
      error_of(with_body(", \"mass\": 1")),
      "s.json:3: /bodies/0: unknown key \"mass\"; there are name, shape, parts, pose, motion, "
      "detection, filter, path");
  EXPECT_EQ(error_of(with_body(", \"motion\": \"static\",\n\"motion\": \"static\"")),
            "s.json:4: the key \"motion\" stands twice in one object");
  EXPECT_EQ(error_of(with_body(", \"detection\": \"fast\"")),
            "s.json:3: /bodies/0/detection: \"fast\" is none of discrete and continuous");
  EXPECT_EQ(error_of(with_body(", \"motion\": \"frozen\"")),
            "s.json:3: /bodies/0/motion: \"frozen\" is none of static, kinematic and dynamic");
  EXPECT_EQ(error_of(with_body("", ", \"steps\": 1e3")),
            "s.json:3: /steps: is not a whole number from 0 to 10000000");
  EXPECT_EQ(error_of(with_body("", ", \"steps\": 99999999999999999999")).substr(0, 17),
            "s.json:3: /steps:");
  EXPECT_EQ(error_of(with_body("", ", \"step\": 0")), "s.json:3: /step: is not positive");
  EXPECT_EQ(
      error_of(with_body("", ", \"units\": {\"length\": \"parsec\"}")),
      "s.json:3: /units/length: there is no unit \"parsec\"; there are m, cm, mm, um, km, in");
}

TEST_F(HostileScene, NamesThatStandTwiceOrForNothing) {
  const std::string shape = "{\"name\": \"s\", \"sphere\": {\"radius\": 1}}";
  EXPECT_EQ(
      error_of("{\"graze_scene\": 1, \"bodies\": [], \"shapes\": [" + shape + ",\n" + shape + "]}"),
      "s.json:2: /shapes/1/name: there is a shape \"s\" already");
  EXPECT_EQ(error_of("{\"graze_scene\": 1, \"shapes\": [], \"bodies\": [{\"name\": \"b\",\n"
                     "\"shape\": \"s\"}]}"),
            "s.json:2: /bodies/0/shape: there is no shape \"s\"");
  EXPECT_EQ(error_of(with_body("", ", \"exclusions\": [[\"b\", \"c\"]]")),
            "s.json:3: /exclusions/0/1: there is no body \"c\"");
  EXPECT_EQ(error_of(with_body("", ", \"exclusions\": [[\"b\", \"b\"]]")),
            "s.json:3: /exclusions/0: a body is excluded from itself");
  EXPECT_EQ(error_of(with_body("", ", \"exclusions\": [[\"b\"]]")),
            "s.json:3: /exclusions/0: has 1 elements, not 2");
}

TEST_F(HostileScene, ShapesThatAreNone) {
  const std::string shapes =
      "shapes, not one of sphere, box, capsule, cylinder, cone, ellipsoid, convex_hull, "
      "half_space, "
      "plane and mesh";
  EXPECT_EQ(error_of(with_shape("\"box\": {\"half_extents\": [1, 1, 1]}, \"sphere\": {}")),
            "s.json:2: /shapes/0: has 2 " + shapes);
  EXPECT_EQ(error_of("{\"graze_scene\": 1, \"bodies\": [], \"shapes\": [{\"name\": \"s\"}]}"),
            "s.json:1: /shapes/0: has 0 " + shapes);
  EXPECT_EQ(error_of(with_shape("\"sphere\": {\"radius\": -1}")),
            "s.json:2: /shapes/0/sphere: sphere: the radius is not positive");
  EXPECT_EQ(error_of(with_shape("\"sphere\": {\"radius\": \"inf\"}")),
            "s.json:2: /shapes/0/sphere/radius: \"inf\" is not a finite double as a hex float, "
            "such as \"0x1.8p+1\"");
  EXPECT_EQ(error_of(with_shape("\"box\": {\"half_extents\": [1, 1]}")),
            "s.json:2: /shapes/0/box/half_extents: has 2 elements, not 3");
  EXPECT_EQ(error_of(with_shape("\"cone\": {\"radius\": 1}")),
            "s.json:2: /shapes/0/cone: has no \"half_height\"");
  EXPECT_EQ(error_of(with_shape("\"half_space\": {\"normal\": [0, 0, 0]}")),
            "s.json:2: /shapes/0/half_space: half-space: the normal is zero");
  const std::string flat = with_shape("\"convex_hull\": {\"points\": [[0,0,0],[1,0,0],[0,1,0]]}");
  EXPECT_EQ(error_of(flat).substr(0, 33), "s.json:2: /shapes/0/convex_hull: ");
  EXPECT_EQ(error_of(with_shape("\"mesh\": {\"vertices\": [[0,0,0]], \"triangles\": [[0,0,7]]}")),
            "s.json:2: /shapes/0/mesh/triangles/0/2: there is no vertex 7; the mesh has 1");
}

TEST_F(HostileScene, HugeCounts) {
  std::string points;
  for (std::size_t i = 0; i <= kMaxHullPoints; ++i)
    points += std::string(i == 0 ? "" : ",") + "[0,0," + std::to_string(i) + "]";
  EXPECT_EQ(error_of(with_shape("\"convex_hull\": {\"points\": [" + points + "]}")),
            "s.json:2: /shapes/0/convex_hull/points: has 4097 points; a hull may have 4096");
  EXPECT_EQ(error_of(with_shape("\"mesh\": {\"vertices\": [[0,0,0]], \"triangles\": "
                                "[[0,0,4294967296]]}")),
            "s.json:2: /shapes/0/mesh/triangles/0/2: is not a whole number from 0 to 4294967295");
  // Bodies that share one shape, as many as the file has room for: linear time.
  std::string bodies;
  for (int i = 0; i < 50000; ++i)
    bodies += std::string(i == 0 ? "" : ",") + "{\"name\": \"" + std::to_string(i) +
              "\", \"shape\": \"s\"}";
  const std::string many =
      "{\"graze_scene\": 1, \"shapes\": [{\"name\": \"s\", \"sphere\": "
      "{\"radius\": 1}}], \"bodies\": [" +
      bodies;
  EXPECT_EQ(error_of(many + "]}"), "");
  EXPECT_EQ(error_of(many + ",\n{\"name\": \"7\", \"shape\": \"s\"}]}"),
            "s.json:2: /bodies/50000/name: there is a body \"7\" already");
}

TEST_F(HostileScene, PosesAndPaths) {
  EXPECT_EQ(error_of(with_body(", \"pose\": [2,0,0,0, 0,2,0,0, 0,0,2,0]")),
            "s.json:3: /bodies/0/pose: pose: not a rotation, max |R^T R - I| is 3, above 1e-06");
  EXPECT_EQ(error_of(with_body(", \"pose\": [1, 0, 0]")),
            "s.json:3: /bodies/0/pose: has 3 elements, not 12");
  EXPECT_EQ(error_of(with_body(", \"pose\": {\"axis\": [0, 0, 1]}")),
            "s.json:3: /bodies/0/pose: an axis needs an angle, and an angle an axis");
  EXPECT_EQ(error_of(with_body(", \"pose\": {\"axis\": [0, 0, 0], \"angle\": 1}")),
            "s.json:3: /bodies/0/pose/axis: is zero, and no direction");
  EXPECT_EQ(error_of(with_body(", \"pose\": {\"position\": [1e101, 0, 0]}")).substr(0, 26),
            "s.json:3: /bodies/0/pose: ");
  EXPECT_EQ(error_of(with_body(", \"motion\": \"static\", \"path\": {\"velocity\": [0, 0, 1]}")),
            "s.json:3: /bodies/0/path: a static body has no path");
  EXPECT_EQ(error_of(with_body(", \"path\": {}")),
            "s.json:3: /bodies/0/path: has no keys, velocity or rate");
  EXPECT_EQ(error_of(with_body(", \"path\": {\"keys\": []}")),
            "s.json:3: /bodies/0/path/keys: has no keys");
  EXPECT_EQ(error_of(with_body(", \"path\": {\"keys\": [{\"time\": 1, \"pose\": {}},\n{\"time\": "
                               "1, \"pose\": {}}]}")),
            "s.json:4: /bodies/0/path/keys/1/time: is not after the key before it");
  EXPECT_EQ(error_of(with_body(", \"pose\": {}, \"path\": {\"keys\": [{\"time\": 1, \"pose\": "
                               "{}}]}")),
            "s.json:3: /bodies/0/pose: a body with keys begins where they say");
  EXPECT_EQ(
      error_of(with_body(", \"path\": {\"keys\": [], \"velocity\": [0, 0, 0]}")),
      "s.json:3: /bodies/0/path: has keys and a velocity or rate; a path has one or the other");
  EXPECT_EQ(error_of(with_body(", \"path\": {\"rate\": 1}")),
            "s.json:3: /bodies/0/path: an axis needs a rate, and a rate an axis");
  EXPECT_EQ(error_of(with_body(", \"filter\": {\"category\": -1}")),
            "s.json:3: /bodies/0/filter/category: is not a whole number from 0 to 4294967295");
  EXPECT_EQ(error_of(with_body(", \"filter\": {\"group\": 2147483648}")),
            "s.json:3: /bodies/0/filter/group: is not a whole number from -2147483648 to "
            "2147483647");
}

TEST_F(HostileScene, LengthsBeyondTheRangeInMetres) {
  EXPECT_EQ(
      error_of(with("\"sphere\": {\"radius\": 1e308}", "", ", \"units\": {\"length\": \"km\"}")),
      "s.json:2: /shapes/0/sphere/radius: is beyond the range of double in metres");
}

TEST_F(HostileScene, MeshFilesThatAreMissingOrElsewhere) {
  std::filesystem::create_directory(folder_.path() / "inner");
  folder_.write("inner/mesh.off", kMesh);
  folder_.write("broken.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n");
  const tests::TemporaryDirectory elsewhere;
  std::filesystem::create_symlink(elsewhere.write("mesh.off", kMesh), folder_.path() / "link.off");
  std::filesystem::create_symlink(folder_.path() / "circle.off", folder_.path() / "circle.off");

  EXPECT_EQ(error_of(with_mesh("inner/mesh.off")), "");
  const std::string place = "s.json:2: /shapes/0/mesh/file: ";
  const std::string missing = error_of(with_mesh("inner/none.off"));
  EXPECT_EQ(missing.substr(0, place.size()), place);
  EXPECT_TRUE(missing.ends_with("none.off: does not exist")) << missing;
  EXPECT_EQ(error_of(with_mesh("../mesh.off")),
            place + "the path \"../mesh.off\" leads out of the folder of the scene");
  EXPECT_EQ(error_of(with_mesh("/etc/passwd")),
            place + "the path \"/etc/passwd\" is absolute; files lie in the folder of the scene");
  EXPECT_EQ(error_of(with_mesh("link.off")),
            place + "the path \"link.off\" is a link out of the folder of the scene");
  EXPECT_EQ(error_of(with_mesh("circle.off")).substr(0, place.size()), place);
  EXPECT_EQ(error_of(with_mesh("inner")).substr(0, place.size()), place);
  EXPECT_EQ(error_of(with_mesh("broken.off")).substr(0, place.size()), place);
  const std::string hash = files::sha256_of(kMesh);
  const auto hashed = [&](const std::string& wanted) {
    return with_shape("\"mesh\": {\"file\": \"inner/mesh.off\",\n\"sha256\": \"" + wanted + "\"}");
  };
  EXPECT_EQ(error_of(hashed(hash)), "");
  EXPECT_EQ(error_of(hashed("00")),
            "s.json:3: /shapes/0/mesh/sha256: the file has the SHA-256 " + hash);
}

TEST_F(HostileScene, ScenesThatCannotBeRead) {
  EXPECT_THROW(read_scene(folder_.path() / "none.json"), SceneError);
  EXPECT_THROW(read_scene(folder_.path()), SceneError);
}

}  // namespace
}  // namespace graze
