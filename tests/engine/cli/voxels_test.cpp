// `graze voxels`: what it writes, says and refuses.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/voxels.h>
#include <nlohmann/json.hpp>

#include <filesystem>

#include "tests/engine/cli/command_test.h"
#include "tests/files/devices.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

using Json = nlohmann::ordered_json;

class CliVoxels : public CommandTest {
 protected:
  CliVoxels() {
    write_mesh("torus.off", make_torus(1, 0.3, 20, 12));
    write_mesh("row.off", make_row(2));
  }

  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
};

TEST_F(CliVoxels, JsonAndFileAreWhatTheLibraryFinds) {
  const Mesh torus = load_mesh(folder_ / "torus.off");
  for (const bool is_solid : {false, true}) {
    std::vector<std::string> arguments = {"voxels", "torus.off",  "--resolution", "40",
                                          "-o",     "voxels.ply", "--json"};
    if (is_solid) arguments.push_back("--solid");
    const CommandResult result = graze(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    ASSERT_EQ(lines_of(result.out).size(), 1u);
    const Voxels expected = find_voxels(
        torus, {.resolution = 40, .fill = is_solid ? VoxelFill::Solid : VoxelFill::Surface});
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["mesh"], "torus.off");
    EXPECT_EQ(json["file"], "voxels.ply");
    EXPECT_EQ(json["fill"], is_solid ? "solid" : "surface");
    EXPECT_EQ(json["counts"], expected.grid.counts);
    EXPECT_EQ(json["edge"], expected.grid.edge);
    EXPECT_EQ(json["origin"][2], expected.grid.origin.z());
    EXPECT_EQ(json["voxels"], expected.size());
    EXPECT_EQ(json["fraction"],
              static_cast<double>(expected.size()) / static_cast<double>(expected.grid.size()));
    EXPECT_GE(json["find_ms"], 0.0);
    EXPECT_GT(json["work"]["triangle_tests"], 0);
    const Mesh boxes = load_mesh(folder_ / "voxels.ply");
    ASSERT_EQ(boxes.triangles().size(), 12 * expected.size());
    EXPECT_EQ(boxes.triangle(0).a, expected.grid.box(expected.voxels[0]).min);
  }
}

TEST_F(CliVoxels, TheReportIsForPeople) {
  const CommandResult result =
      graze({"voxels", "row.off", "--resolution", "11", "--output", "v.obj", "--threads", "1"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 9u) << result.out;
  EXPECT_EQ(lines[0], "v.obj");
  EXPECT_EQ(lines[1], "  grid                    11 x 1 x 1");
  EXPECT_EQ(lines[2], "  voxel edge (m)          1");
  EXPECT_EQ(lines[4], "  voxels                  4 (surface)") << "two of them touch in an edge";
  EXPECT_EQ(lines[5], "  of the grid             36.36 %");
  EXPECT_EQ(load_mesh(folder_ / "v.obj").triangles().size(), 48u);
}

TEST_F(CliVoxels, ThreadsChangeNothing) {
  for (const char* threads : {"1", "7"}) {
    const CommandResult result = graze({"voxels", "torus.off", "--resolution", "30", "--solid",
                                        "-o", std::string(threads) + ".obj", "--threads", threads});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
  }
  EXPECT_EQ(run_shell(folder_, "cmp 1.obj 7.obj").exit_code, 0);
}

TEST_F(CliVoxels, BadNumbersAreRefused) {
  const auto refuse = [&](const char* option, const std::string& value, const std::string& range) {
    std::vector<std::string> arguments = {"voxels", "torus.off", "-o", "v.obj"};
    arguments.push_back(std::string(option) + "=" + value);
    if (option != std::string("--resolution"))
      arguments.insert(arguments.end(), {"--resolution", "8"});
    expect_refusal(arguments, std::string("graze: ") + option + ": \"" + value +
                                  "\" is not a whole number from " + range);
    EXPECT_FALSE(exists("v.obj"));
  };
  for (const char* value :
       {"0", "-1", "65536", "99999999999999", "1.5", "1e3", "0x10", "ten", "nan"})
    refuse("--resolution", value, "1 to 65535");
  for (const char* value : {"-1", "1025", "many"})
    refuse("--threads", value, "0 to 1024");
  // A leading zero is no octal number.
  EXPECT_EQ(graze({"voxels", "torus.off", "-o", "v.obj", "--resolution", "010"}).exit_code, 0);
  expect_refusal(
      {"voxels", "row.off", "-o", "v.obj", "--resolution", "65535", "--solid"},
      "graze: row.off: the mesh is not closed: it has 6 boundary edges, the first from vertex 0 to "
      "vertex 1 of triangle 0");
}

TEST_F(CliVoxels, BadFilesAreRefused) {
  const auto refuse = [&](const std::string& mesh, const std::string& file,
                          const std::string& message) {
    expect_refusal({"voxels", mesh, "--resolution", "8", "-o", file, "--json"},
                   "graze: " + message);
  };
  refuse("torus.off", "v.stl",
         "v.stl: unknown extension \".stl\", voxels are written to .obj .ply");
  refuse("torus.off", "", ": no extension, voxels are written to .obj .ply");
  refuse("torus.off", "missing/v.ply",
         "missing/v.ply: cannot be written: No such file or directory");
  refuse("missing.off", "v.ply", "missing.off: does not exist");
  EXPECT_FALSE(exists("v.ply"));
  write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  refuse("mesh.obj", "./mesh.obj", "-o: ./mesh.obj is the mesh itself");
  write_mesh("huge.off", make_box({1.7e308, 1, 1}));
  refuse("huge.off", "v.ply", "huge.off: voxel grid: the length of the bounds overflows");
}

TEST_F(CliVoxels, AFullDiskIsBadInput) {
  const TemporaryDirectory devices;
  const std::string full = spare_device(Device::Full, devices.path());
  if (full.empty()) GTEST_SKIP() << "no device to try it on";
  std::filesystem::create_symlink(full, folder_ / "full.ply");
  expect_refusal({"voxels", "torus.off", "--resolution", "8", "-o", "full.ply"},
                 "graze: full.ply: cannot be written: No space left on device");
}

TEST_F(CliVoxels, ProgressIsReportedOnlyForLongWork) {
  const CommandResult result =
      graze({"voxels", "torus.off", "--resolution", "8", "-o", "v.ply", "--progress"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
}

}  // namespace
}  // namespace graze::tests
