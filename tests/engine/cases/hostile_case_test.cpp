// Files that are no cases are refused by one line that names the file and the place.

#include <graze/engine/cases/read_case.h>
#include <graze/engine/files/sha256.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <string>

#include "tests/files/temporary_directory.h"

namespace graze {
namespace {

constexpr const char* kMesh = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

class HostileCase : public testing::Test {
 protected:
  std::string error_of(const std::string& text) const {
    try {
      parse_case(text, "case.json", {.mesh_folder = folder_.path()});
    } catch (const CaseError& error) {
      return error.what();
    }
    return "";
  }

  /// A case about a triangle and the given B, or with another part replaced.
  static std::string with(const std::string& members) {
    return "{\"graze_case\": 1, \"question\": \"any\",\n\"a\": "
           "{\"triangle\": [[0,0,0],[1,0,0],[0,1,0]]},\n" +
           members + "}";
  }

  static std::string with_mesh_b(const std::string& mesh) {
    return "{\"graze_case\": 1, \"question\": \"any\",\n\"a\": {\"mesh\": {\"vertices\": "
           "[[0,0,0],[1,0,0],[0,1,0]], \"triangles\": [[0,1,2]]}},\n\"b\": {\"mesh\": " +
           mesh + "}}";
  }

  tests::TemporaryDirectory folder_;
};

TEST_F(HostileCase, TheHarmlessOneIsRead) {
  EXPECT_EQ(error_of(with("\"b\": {\"sphere\": {\"centre\": [0,0,0], \"radius\": 1}}")), "");
  EXPECT_EQ(error_of(with_mesh_b("{\"same_as\": \"a\"}")), "");
}

TEST_F(HostileCase, WhatIsNoJson) {
  EXPECT_EQ(error_of("{\"graze_case\": 1,\n\n]").substr(0, 22), "case.json:3: not JSON:");
  EXPECT_EQ(error_of("").substr(0, 22), "case.json:1: not JSON:");
  EXPECT_EQ(error_of("{\"graze_case\": 1} x").substr(0, 22), "case.json:1: not JSON:");
  EXPECT_EQ(error_of("{\"note\": \"\xff\"}").substr(0, 29), "case.json:1: /note: not JSON:");
  EXPECT_EQ(error_of("{\"graze_case\": 1, \"a\": 1e999}"),
            "case.json:1: /a: not JSON: number overflow parsing '1e999'");
  EXPECT_EQ(error_of("[NaN]").substr(0, 26), "case.json:1: /0: not JSON:");
  EXPECT_EQ(error_of("{\"a\": {\"triangle\": [[0, 0, 0],\n[1, NaN, 0]]}}").substr(0, 42),
            "case.json:2: /a/triangle/1/1: not JSON: sy");
  EXPECT_EQ(error_of("{\"a\": 1 \"b\": 2}").substr(0, 22), "case.json:1: not JSON:")
      << "between two members";
}

TEST_F(HostileCase, DeepNesting) {
  EXPECT_EQ(error_of(std::string(1000000, '[')), "case.json:1: nested deeper than 32 levels");
  std::string objects;
  for (int i = 0; i < 100000; ++i)
    objects += "{\"a\":\n";
  EXPECT_EQ(error_of(objects), "case.json:33: nested deeper than 32 levels");
}

TEST_F(HostileCase, RepeatedAndUnknownKeys) {
  EXPECT_EQ(error_of(with("\"b\": {\"box\": {\"min\": [0,0,0],\n\"min\": [0,0,0]}}")),
            "case.json:4: the key \"min\" stands twice in one object");
  EXPECT_EQ(error_of(with("\"b\": {\"box\": {\"min\": [0,0,0],\n\"mox\": [0,0,0]}}")),
            "case.json:3: /b/box: unknown key \"mox\"; there are min, max");
  EXPECT_EQ(error_of(with("\"extra\": 1")),
            "case.json:1: unknown key \"extra\"; there are graze_case, note, origin, question, "
            "settings, a, "
            "b, answer, answered_by");
  std::string members;
  for (int i = 0; i < 1000; ++i)
    members += "\"k" + std::to_string(i) + "\": 1,";
  EXPECT_EQ(error_of("{" + members + "\"x\": 1}"),
            "case.json:1: an object with more than 64 members");
}

TEST_F(HostileCase, NumbersThatAreNone) {
  const auto radius = [](const std::string& text) {
    return with("\"b\": {\"sphere\": {\"centre\": [0,0,0],\n\"radius\": " + text + "}}");
  };
  EXPECT_EQ(error_of(radius("\"nan\"")),
            "case.json:4: /b/sphere/radius: \"nan\" is not a finite double as a hex float, such as "
            "\"0x1.8p+1\"");
  EXPECT_EQ(error_of(radius("\"0x1p+1024\"")).substr(0, 31), "case.json:4: /b/sphere/radius: ");
  EXPECT_EQ(error_of(radius("true")), "case.json:4: /b/sphere/radius: is a boolean, not a number");
  EXPECT_EQ(error_of(radius("1e999")),
            "case.json:4: /b/sphere/radius: not JSON: number overflow parsing '1e999'");
  EXPECT_EQ(error_of(radius("-1")).substr(0, 23), "case.json:3: /b/sphere:");
}

TEST_F(HostileCase, CountsAndIndices) {
  EXPECT_EQ(error_of(with_mesh_b("{\"vertices\": [[0,0,0]], \"triangles\": [[0,0,\n4294967295]]}")),
            "case.json:4: /b/mesh/triangles/0/2: there is no vertex 4294967295; the mesh has 1");
  EXPECT_EQ(error_of(with_mesh_b("{\"vertices\": [[0,0,0]], \"triangles\": [[0,0,1e18]]}")),
            "case.json:3: /b/mesh/triangles/0/2: is not a whole number from 0 to 4294967295");
  EXPECT_EQ(error_of(with_mesh_b("{\"vertices\": [[0,0,0]], \"triangles\": [[0,0,-1]]}")),
            "case.json:3: /b/mesh/triangles/0/2: is not a whole number from 0 to 4294967295");
  EXPECT_EQ(error_of(with_mesh_b("{\"vertices\": [[0,0]], \"triangles\": []}")),
            "case.json:3: /b/mesh/vertices/0: has 2 elements, not 3");
  EXPECT_EQ(error_of(with_mesh_b("{\"vertices\": [], \"triangles\": []}")).substr(0, 21),
            "case.json:3: /b/mesh:");
  EXPECT_EQ(error_of("{\"graze_case\": 99999999999}").substr(0, 25), "case.json:1: /graze_case:");
  EXPECT_EQ(error_of("{\"graze_case\": 2}"),
            "case.json:1: /graze_case: is version 2; this program reads 1");
}

TEST_F(HostileCase, BodiesThatAreNone) {
  const auto body = [](const std::string& shape, const std::string& more = "") {
    return "{\"graze_case\": 1, \"question\": \"any\",\n\"a\": {\"body\": {\"sphere\": "
           "{\"radius\": 1}}},"
           "\n\"b\": {\"body\": {" +
           shape + "}" + more + "}}";
  };
  EXPECT_EQ(error_of(body("\"cone\": {\"radius\": 1, \"half_height\": 2}")), "");
  EXPECT_EQ(error_of(body("\"cone\": {\"radius\": 1}")),
            "case.json:3: /b/body/cone: has no \"half_height\"");
  EXPECT_EQ(error_of(body("\"box\": {\"half_extents\": [1, 0, 1]}")),
            "case.json:3: /b/body/box: box: half extent y is not positive");
  EXPECT_EQ(error_of(body("\"prism\": {}")).substr(0, 41),
            "case.json:3: /b/body: unknown key \"prism\"");
  EXPECT_EQ(error_of(body("")).substr(0, 37), "case.json:3: /b/body: has 0 shapes, n");
  EXPECT_EQ(error_of(body("\"mesh\": {\"same_as\": \"a\"}")).substr(0, 27),
            "case.json:3: /b/body/mesh: ");
  EXPECT_EQ(error_of(body("\"box\": {\"half_extents\": [1, 1, 1]}",
                          ",\"pose\": [1,0,0,1e300, 0,1,0,0, 0,0,1,0]"))
                .substr(0, 21),
            "case.json:3: /b/pose:");
  EXPECT_NE(error_of(with("\"b\": {\"body\": {\"sphere\": {\"radius\": 1}}}"))
                .find("no query answers \"any\" for a triangle and a body"),
            std::string::npos);
}

TEST_F(HostileCase, MeshesThatReferToEachOther) {
  const std::string circle =
      "{\"graze_case\": 1, \"question\": \"any\", \"a\": {\"mesh\": {\"same_as\": \"b\"}},\n"
      "\"b\": {\"mesh\": {\"same_as\": \"a\"}}}";
  EXPECT_EQ(error_of(circle),
            "case.json:2: /b/mesh/same_as: the meshes refer to each other in a circle");
  EXPECT_EQ(error_of(with_mesh_b("{\"same_as\": \"b\"}")),
            "case.json:3: /b/mesh/same_as: the meshes refer to each other in a circle");
  EXPECT_EQ(error_of(with_mesh_b("{\"same_as\": \"c\"}")),
            "case.json:3: /b/mesh/same_as: is neither \"a\" nor \"b\"");
}

TEST_F(HostileCase, PathsOutOfTheFolder) {
  const std::string hash = files::sha256_of(kMesh);
  const auto file = [&](const std::string& path) {
    return with_mesh_b("{\"file\": \"" + path + "\", \"sha256\": \"" + hash + "\"}");
  };
  std::filesystem::create_directory(folder_.path() / "inner");
  folder_.write("inner/mesh.off", kMesh);
  const tests::TemporaryDirectory elsewhere;
  const std::string outside = elsewhere.write("mesh.off", kMesh);
  std::filesystem::create_symlink(outside, folder_.path() / "link.off");
  std::filesystem::create_symlink(elsewhere.path(), folder_.path() / "way");

  EXPECT_EQ(error_of(file("inner/mesh.off")), "");
  const std::string place = "case.json:3: /b/mesh: the path ";
  EXPECT_EQ(error_of(file("../mesh.off")),
            place + "\"../mesh.off\" leads out of the folder of the case");
  EXPECT_EQ(error_of(file("inner/../../mesh.off")).substr(0, place.size()), place);
  EXPECT_EQ(error_of(file("/etc/passwd")),
            place + "\"/etc/passwd\" is absolute; files lie in the folder of the case");
  EXPECT_EQ(error_of(file("link.off")),
            place + "\"link.off\" is a link out of the folder of the case");
  EXPECT_EQ(error_of(file("way/mesh.off")),
            place + "\"way/mesh.off\" is a link out of the folder of the case");
  EXPECT_EQ(error_of(file("")), place + "\"\" names no file");
  EXPECT_EQ(error_of(file("inner\\u0000/mesh.off")).substr(0, place.size()), place);
  EXPECT_EQ(error_of(file("inner")), "case.json:3: /b/mesh: inner: is a directory");
}

TEST_F(HostileCase, FilesWithAnotherHash) {
  folder_.write("mesh.off", kMesh);
  const std::string wrong(64, '0');
  EXPECT_EQ(error_of(with_mesh_b("{\"file\": \"mesh.off\",\n\"sha256\": \"" + wrong + "\"}")),
            "case.json:3: /b/mesh: the file \"mesh.off\" has the SHA-256 " +
                files::sha256_of(kMesh) + ", not " + wrong);
  EXPECT_EQ(error_of(with_mesh_b("{\"file\": \"mesh.off\",\n\"sha256\": \"00\"}")),
            "case.json:4: /b/mesh/sha256: is not a SHA-256 of 64 digits 0-9 a-f");
}

TEST_F(HostileCase, AFileThatIsReadOnceForManyCases) {
  folder_.write("mesh.off", kMesh);
  const std::string hash = files::sha256_of(kMesh);
  const auto with_hash = [&](const std::string& sha256) {
    return with_mesh_b("{\"file\": \"mesh.off\",\n\"sha256\": \"" + sha256 + "\"}");
  };
  CaseMeshes meshes;
  const auto read = [&](const std::string& text) {
    return parse_case(text, "case.json", {.mesh_folder = folder_.path(), .meshes = &meshes});
  };
  EXPECT_THROW(read(with_hash(std::string(64, '0'))), CaseError) << "of no such file";
  const Case first = read(with_hash(hash));
  folder_.write("mesh.off", "OFF\n0 0 0\n");
  const Case second = read(with_hash(hash));
  EXPECT_EQ(std::get<CaseMesh>(*first.b).mesh, std::get<CaseMesh>(*second.b).mesh) << "a handle";
  EXPECT_THROW(read(with_hash(files::sha256_of("OFF\n0 0 0\n"))), CaseError)
      << "another file than the one that was read";
  EXPECT_NE(error_of(with_hash(hash)), "") << "without them it is read anew";
}

TEST_F(HostileCase, PosesThatAreNotRigid) {
  EXPECT_EQ(error_of(with_mesh_b("{\"same_as\": \"a\"}, \"pose\": [2,0,0,0, 0,2,0,0, 0,0,2,0]")),
            "case.json:3: /b/pose: the pose: not a rotation, max |R^T R - I| is 3, above 1e-06");
  EXPECT_EQ(error_of(with_mesh_b("{\"same_as\": \"a\"}, \"pose\": [1,0,0]")),
            "case.json:3: /b/pose: has 3 elements, not 12");
}

TEST_F(HostileCase, QuestionsThatNobodyCanAnswer) {
  EXPECT_EQ(error_of("{\"graze_case\": 1, \"question\": \"contacts\",\n"
                     "\"a\": {\"point\": [0,0,0]}, \"b\": {\"point\": [0,0,0]}}"),
            "case.json:1: /question: no query answers \"contacts\" for a point and a point");
  EXPECT_EQ(
      error_of(with("\"b\": {\"point\": [0,0,0]}, \"answer\": {\"says\": true}")).substr(0, 12),
      "case.json:1:");
  EXPECT_EQ(error_of(with("\"b\": {\"sphere\": {\"centre\": [0,0,0], \"radius\": 1}}, \"answer\": "
                          "{\"distance\": 1},\n\"answered_by\": {\"engine\": \"x\"}")),
            "case.json:3: /answer: unknown key \"distance\"; there are says");
}

TEST_F(HostileCase, NegativeDistancesAreClaimsButNegativeLengthsAreNone) {
  const auto answer = [](const std::string& question, const std::string& text) {
    const std::string mesh =
        "{\"mesh\": {\"vertices\": [[0,0,0],[1,0,0],[0,1,0]], \"triangles\": [[0,1,2]]}}";
    return "{\"graze_case\": 1, \"question\": \"" + question + "\", \"a\": " + mesh +
           ", \"b\": " + mesh + ",\n\"answer\": " + text +
           ", \"answered_by\": {\"engine\": \"x\"}}";
  };
  const std::string claim = answer("distance", "{\"distance\": -0.5}");
  EXPECT_EQ(error_of(claim), "");
  EXPECT_EQ(parse_case(claim, "case.json").answer->distance, -0.5);
  EXPECT_EQ(error_of(answer("separation", "{\"distance\": -1, \"translation\": [0,0,0]}")),
            "case.json:2: /answer/distance: is negative");
}

TEST_F(HostileCase, NamesThatWouldMoveACursor) {
  const auto by = [](const std::string& members) {
    return with(
        "\"b\": {\"sphere\": {\"centre\": [0,0,0], \"radius\": 1}}, \"answer\": "
        "{\"says\": true},\n\"answered_by\": {" +
        members + "}");
  };
  EXPECT_EQ(error_of(by("\"engine\": \"f\\u00fcr 3D\"")), "");
  const std::string engine = "case.json:4: /answered_by/engine: is a name ";
  EXPECT_EQ(error_of(by("\"engine\": \"\\u001b[2Jx\"")), engine + "with a control character");
  EXPECT_EQ(error_of(by("\"engine\": \"\\u0085\"")), engine + "with a control character");
  EXPECT_EQ(error_of(by("\"engine\": \"\\u007f\"")), engine + "with a control character");
  EXPECT_EQ(error_of(by("\"engine\": \"x\", \"version\": \"a\\nb\"")),
            "case.json:4: /answered_by/version: is a name with a control character");
  EXPECT_EQ(error_of(by("\"engine\": \"" + std::string(128, 'x') + "\"")), "");
  EXPECT_EQ(error_of(by("\"engine\": \"" + std::string(129, 'x') + "\"")),
            engine + "of 129 bytes, more than 128");
}

TEST_F(HostileCase, FilesThatCannotBeRead) {
  EXPECT_THROW(read_case(folder_.path() / "none.json"), CaseError);
  EXPECT_THROW(read_case(folder_.path()), CaseError);
}

}  // namespace
}  // namespace graze
