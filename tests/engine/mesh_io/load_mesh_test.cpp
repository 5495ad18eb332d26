#include <tests/engine/mesh_io/loading.h>
#include <tests/engine/mesh_io/samples.h>

#include <sys/stat.h>
#include <algorithm>

// What all formats have in common, and what load_mesh() says of files that it need not look into.

namespace graze::mesh_io {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

std::vector<Corners> corners_of(const Mesh& mesh) {
  std::vector<Corners> corners;
  for (const TriangleIndices& t : mesh.triangles()) {
    corners.push_back({mesh.vertices()[t[0]], mesh.vertices()[t[1]], mesh.vertices()[t[2]]});
  }
  return corners;
}

/// Each edge is in as many triangles one way as the other way.
bool is_closed(const Mesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> forward, backward;
  for (const TriangleIndices& t : mesh.triangles()) {
    for (int k = 0; k < 3; ++k) {
      forward.emplace_back(t[k], t[(k + 1) % 3]);
      backward.emplace_back(t[(k + 1) % 3], t[k]);
    }
  }
  std::ranges::sort(forward);
  std::ranges::sort(backward);
  return forward == backward;
}

TEST(LoadMesh, TheSameCubeInEveryFormat) {
  const std::vector<Corners> expected = corners_of(load("cube.obj", cube_obj()));
  ASSERT_EQ(expected.size(), 12u);
  EXPECT_EQ(expected[0][1], Eigen::Vector3d(-0.25, 0.5, -0.25));
  for (const Sample& cube : cubes()) {
    const Mesh mesh = load(cube.name, cube.bytes);
    EXPECT_EQ(mesh.vertices().size(), 8u) << cube.name;
    EXPECT_EQ(corners_of(mesh), expected) << cube.name;
    EXPECT_TRUE(is_closed(mesh)) << cube.name;
  }
}

TEST(LoadMesh, TheExtensionMayBeInCapitals) {
  EXPECT_EQ(load("CUBE.OBJ", cube_obj()).triangles().size(), 12u);
  EXPECT_EQ(load("cube.Stl", cube_stl_binary()).triangles().size(), 12u);
}

TEST(LoadMesh, LinesMayEndAnyWay) {
  for (const Sample& cube :
       {Sample{"a.obj", cube_obj()}, Sample{"a.off", cube_off()}, Sample{"a.stl", cube_stl_ascii()},
        Sample{"a.ply", cube_ply_ascii()}}) {
    for (const std::string_view line_end : {"\r\n", "\r", "\n\n", " \t\n"}) {
      std::string bytes;
      for (const char c : cube.bytes)
        bytes += c == '\n' ? std::string(line_end) : std::string(1, c);
      EXPECT_EQ(load(cube.name, bytes).triangles().size(), 12u) << cube.name;
    }
    EXPECT_EQ(load(cube.name, "\xef\xbb\xbf" + cube.bytes).triangles().size(), 12u) << cube.name;
    const std::string without_last(cube.bytes.substr(0, cube.bytes.size() - 1));
    EXPECT_EQ(load(cube.name, without_last).triangles().size(), 12u) << cube.name;
  }
}

TEST(LoadMesh, TextKeepsAllItsDigits) {
  const std::string obj =
      "v 0.1 1e-320 179769313486231570e291\nv +1 -.5 3.\nv 1E+2 0 -0\nf 1 2 3\n";
  const Mesh mesh = load("a.obj", obj);
  EXPECT_EQ(mesh.vertices()[0], Eigen::Vector3d(0.1, 1e-320, std::numeric_limits<double>::max()));
  EXPECT_EQ(mesh.vertices()[1], Eigen::Vector3d(1, -0.5, 3));
  EXPECT_EQ(mesh.vertices()[2], Eigen::Vector3d(100, 0, 0));
  EXPECT_TRUE(std::signbit(mesh.vertices()[2].z()));
  EXPECT_EQ(load("a.obj", "v 1e-999 0 0.30000000000000004\nf 1 1 1").vertices()[0],
            Eigen::Vector3d(0, 0, 0.1 + 0.2));
}

/// The same number as text in each format.
TEST(LoadMesh, TextNeverPassesThroughFloat) {
  for (Sample sample : cubes()) {
    if (!sample.name.starts_with("ascii")) continue;
    for (auto at = sample.bytes.find("0.5"); at != std::string::npos;
         at = sample.bytes.find("0.5")) {
      sample.bytes.replace(at, 3, "0.1");
    }
    const Mesh mesh = load(sample.name, sample.bytes);
    EXPECT_EQ(mesh.bounds().max, Eigen::Vector3d(0.1, 0.1, 0.1)) << sample.name;
  }
}

TEST(LoadMesh, OtherWordsForNumbersAreErrors) {
  for (const std::string_view bad :
       {"1e999", "-1e999", "nan",   "-nan", "nan(1)", "inf", "-inf", "Infinity",
        "0x10",  "1.0abc", "1.0.0", "1,5",  "--1",    "+-1", "-+1",  "++1",
        "+",     "-",      ".",     "e5",   "1e",     "1#",  "x"}) {
    const std::string text(bad);
    const std::string why = "\"" + text + "\" is not a finite number";
    EXPECT_EQ(error_of("a.obj", "v 0 0 0\nv 0 " + text + " 0\n"), "a.obj:2: " + why);
    EXPECT_EQ(error_of("a.off", "OFF\n3 1 0\n\n0 0 " + text + "\n"), "a.off:4: " + why);
    EXPECT_EQ(error_of("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex\n0 " + text + " 0"),
              "a.stl:5: " + why);
    EXPECT_EQ(
        error_of("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                 "property float z\nend_header\n" +
                     text + " 0 0\n"),
        "a.ply:8: " + why);
  }
}

TEST(LoadMesh, MessagesStayShortAndPrintable) {
  EXPECT_EQ(error_of("a.obj", std::string_view("\x01\x7f\xe4\0 1", 6)),
            "a.obj:1: unknown statement \"\\x01\\x7f\\xe4\\x00\"");
  EXPECT_EQ(error_of("a.obj", std::string(1000, 'x')),
            "a.obj:1: unknown statement \"" + std::string(30, 'x') + "...\"");
  const TemporaryDirectory directory;
  try {
    load_mesh(directory.path("two\nlines.obj"));
    FAIL();
  } catch (const MeshError& error) {
    EXPECT_EQ(error.what(), directory.path("two\\x0alines.obj: does not exist"));
  }
}

TEST(LoadMesh, FilesThatAreNone) {
  const TemporaryDirectory directory;
  const auto error = [&](const std::string& name) -> std::string {
    try {
      load_mesh(directory.path(name));
    } catch (const MeshError& e) {
      return std::string(e.what()).substr(directory.path("").size());
    }
    return "";
  };
  EXPECT_EQ(error("a.obj"), "a.obj: does not exist");
  std::filesystem::create_directory(directory.path("b.obj"));
  EXPECT_EQ(error("b.obj"), "b.obj: is a directory");
  ASSERT_EQ(mkfifo(directory.path("c.obj").c_str(), 0600), 0);
  EXPECT_EQ(error("c.obj"), "c.obj: is not a regular file");
  std::filesystem::create_symlink("circle.obj", directory.path("circle.obj"));
  EXPECT_EQ(error("circle.obj"), "circle.obj: cannot be read: Too many levels of symbolic links");
  for (const std::string name : {"empty.obj", "empty.stl", "empty.ply", "empty.off"}) {
    directory.write(name, "");
    EXPECT_EQ(error(name), name + ": is empty");
  }
  directory.write("mesh", "v");
  EXPECT_EQ(error("mesh"), "mesh: no extension, known are .obj .stl .ply .off");
  directory.write("mesh.Step", "v");
  EXPECT_EQ(error("mesh.Step"),
            "mesh.Step: unknown extension \".Step\", known are .obj .stl .ply .off");
}

/// A file that exists, opens and then refuses to be read.
TEST(LoadMesh, ReadErrorsAreReported) {
  const std::filesystem::path memory = "/proc/self/mem";
  if (!std::filesystem::is_regular_file(memory)) GTEST_SKIP() << "needs " << memory;
  const TemporaryDirectory directory;
  std::filesystem::create_symlink(memory, directory.path("a.obj"));
  try {
    load_mesh(directory.path("a.obj"));
    FAIL();
  } catch (const MeshError& error) {
    EXPECT_EQ(error.what(), directory.path("a.obj: cannot be read: Input/output error"));
  }
}

TEST(LoadMesh, WhatTheMeshRefusesNamesTheFile) {
  EXPECT_EQ(error_of("a.obj", "v 0 0 0\n"), "a.obj: no triangles");
  EXPECT_EQ(error_of("a.off", "OFF 0 0 0"), "a.off: no triangles");
  EXPECT_EQ(error_of("a.stl", "solid\nendsolid"), "a.stl: no triangles");
  EXPECT_EQ(error_of("a.stl", std::string(84, '\0')), "a.stl: no triangles");
  EXPECT_EQ(error_of("a.ply", "ply\nformat ascii 1.0\nend_header\n"), "a.ply: no triangles");
}

}  // namespace
}  // namespace graze::mesh_io
