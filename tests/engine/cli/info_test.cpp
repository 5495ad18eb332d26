// What `graze info` says, and which files it refuses.

#include <graze/bvh/tree/statistics.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/load_mesh.h>
#include <nlohmann/json.hpp>

#include "tests/engine/cli/command_test.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

using Json = nlohmann::ordered_json;

class CliInfo : public CommandTest {
 protected:
  CliInfo() {
    write_mesh("box.off", make_box({1, 2, 0.5}));
    write_mesh("row.off", make_row(3));
  }
};

TEST_F(CliInfo, JsonIsOneObjectPerMesh) {
  const CommandResult result = graze({"info", "--json", "box.off", "row.off"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 2u);
  const Json box = Json::parse(lines[0]);
  EXPECT_EQ(box["file"], "box.off");
  EXPECT_EQ(box["triangles"], 12);
  EXPECT_EQ(box["vertices"], 8);
  EXPECT_EQ(box["welded_vertices"], 8);
  EXPECT_EQ(box["bounds"]["min"], Json::array({-1.0, -2.0, -0.5}));
  EXPECT_EQ(box["bounds"]["max"], Json::array({1.0, 2.0, 0.5}));
  EXPECT_EQ(box["size"], Json::array({2.0, 4.0, 1.0}));
  EXPECT_EQ(box["closed"], true);
  EXPECT_EQ(box["components"], 1);
  EXPECT_EQ(box["boundary_edges"], 0);
  EXPECT_EQ(box["degenerate_triangles"], 0);
  EXPECT_EQ(box["duplicate_triangles"], 0);
  for (const char* on_request : {"self_intersections", "fit", "levels", "health"})
    EXPECT_FALSE(box.contains(on_request)) << on_request;
  const Json row = Json::parse(lines[1]);
  EXPECT_EQ(row["closed"], false);
  EXPECT_EQ(row["components"], 3);
  EXPECT_EQ(row["boundary_edges"], 9);
}

TEST_F(CliInfo, LevelsSumOverAllNodes) {
  write_mesh("torus.off", make_torus(2, 0.5, 24, 12));
  const Json report = Json::parse(graze({"info", "--fit", "--json", "torus.off"}).out);
  const Json& levels = report["levels"];
  ASSERT_EQ(levels.size(), report["tree"]["depth"].get<std::size_t>() + 1);
  std::size_t nodes = 0;
  for (const Json& level : levels)
    nodes += level["nodes"].get<std::size_t>();
  EXPECT_EQ(nodes, report["tree"]["nodes"]);
  EXPECT_EQ(levels[0]["nodes"], 1);
  EXPECT_NEAR(levels[0]["aabb_volume"], 5 * 5 * 1, 1e-4);
  // The bevelled edges cut four prisms of (2 - sqrt 2) / 2 * 2.5 off each corner along z, and less
  // along x and y; the sphere has the diagonal of what the torus reaches.
  EXPECT_LT(levels[0]["kdop"], 0.87);
  EXPECT_GT(levels[0]["kdop"], 0.7);
  EXPECT_GT(levels[0]["sphere"], 2);
  EXPECT_LT(levels[levels.size() - 2]["obb"], 1);
}

TEST_F(CliInfo, TreeStatisticsAreTheTrees) {
  write_mesh("row.off", make_row(100));
  const Json tree = Json::parse(graze({"info", "--json", "row.off"}).out)["tree"];
  const bvh::TreeStatistics expected = bvh::statistics_of(tree_of(load_mesh(folder_ / "row.off")));
  EXPECT_GT(expected.leaf_count, 1u);
  EXPECT_EQ(tree["nodes"], expected.node_count);
  EXPECT_EQ(tree["leaves"], expected.leaf_count);
  EXPECT_EQ(tree["depth"], expected.depth);
  EXPECT_EQ(tree["largest_leaf"], expected.largest_leaf);
  EXPECT_EQ(tree["mean_leaf"], expected.mean_leaf_size);
  EXPECT_EQ(tree["expected_node_visits"], expected.expected_node_visits);
  EXPECT_EQ(tree["expected_triangle_tests"], expected.expected_primitive_tests);
  EXPECT_EQ(tree["bytes"], expected.bytes);
}

TEST_F(CliInfo, ClosedMeshesSayWhatTheirVolumesLeaveEmpty) {
  const CommandResult result = graze({"info", "--fit", "--json", "box.off"});
  const Json fit = Json::parse(result.out)["fit"];
  EXPECT_NEAR(fit["enclosed_volume"], 8, 1e-14);
  EXPECT_EQ(fit["aabb"]["volume"], 8);
  EXPECT_EQ(fit["aabb"]["surface"], 28);
  const double sphere_volume = fit["sphere"]["volume"];
  EXPECT_NEAR(fit["sphere"]["empty_per_cent"], 100 * (1 - 8 / sphere_volume), 1e-12);
  for (const char* name : {"aabb", "obb", "kdop"}) {
    EXPECT_NEAR(fit[name]["empty_per_cent"], 0, 1e-12) << name;
    EXPECT_FALSE(fit[name].contains("relative_to_aabb"));
  }
  const std::string table = graze({"info", "--fit", "box.off"}).out;
  EXPECT_NE(table.find("  enclosed volume (m^3)   8\n"), std::string::npos) << table;
  EXPECT_NE(table.find("  aabb                    8             28             0.0\n"),
            std::string::npos)
      << table;
}

TEST_F(CliInfo, OpenMeshesSayHowTheirVolumesCompareWithTheBounds) {
  write("open.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n");
  const Json fit = Json::parse(graze({"info", "--fit", "--json", "open.off"}).out)["fit"];
  EXPECT_FALSE(fit.contains("enclosed_volume"));
  EXPECT_EQ(fit["aabb"]["relative_to_aabb"], 1);
  EXPECT_LT(fit["kdop"]["relative_to_aabb"], 0.5);
  EXPECT_FALSE(fit["kdop"].contains("empty_per_cent"));
  const std::string table = graze({"info", "--fit", "open.off"}).out;
  EXPECT_EQ(table.find("enclosed volume"), std::string::npos);
  EXPECT_NE(table.find("  aabb                    1             6              1.000\n"),
            std::string::npos)
      << table;
}

TEST_F(CliInfo, MeshesTooLargeForVolumesAreStillReported) {
  write("huge.off", "OFF\n3 1 0\n-1.7e308 -1.7e308 0\n1.7e308 0 0\n0 1.7e308 0\n3 0 1 2\n");
  const CommandResult result = graze({"info", "--fit", "--json", "huge.off"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(Json::parse(result.out)["fit"].is_null());
  EXPECT_NE(graze({"info", "--fit", "huge.off"}).out.find("too large for numbers"),
            std::string::npos);
}

TEST_F(CliInfo, AMeshMayBeNamedLikeASubcommand) {
  const CommandResult result = graze({"info", "pair"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err.find("graze: pair: "), 0u) << result.err;
}

TEST_F(CliInfo, CountsWhatIsDegenerateAndDuplicate) {
  write("odd.off",
        "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n2 0 0\n1 0 0\n"
        "3 0 1 2\n3 2 0 4\n3 0 1 3\n3 0 1 1\n");
  const Json odd = Json::parse(graze({"info", "--json", "odd.off"}).out);
  EXPECT_EQ(odd["vertices"], 5);
  EXPECT_EQ(odd["welded_vertices"], 4);
  EXPECT_EQ(odd["duplicate_triangles"], 1);
  EXPECT_EQ(odd["degenerate_triangles"], 2);
}

TEST_F(CliInfo, SelfCountsIntersections) {
  EXPECT_EQ(Json::parse(graze({"info", "--json", "--self", "box.off"}).out)["self_intersections"],
            0);
  write("cross.off",
        "OFF\n6 2 0\n-1 -1 0\n1 -1 0\n0 1 0\n0 0 -1\n0 0 1\n0 -3 0\n3 0 1 2\n3 3 4 5\n");
  EXPECT_EQ(Json::parse(graze({"info", "--json", "--self", "cross.off"}).out)["self_intersections"],
            1);
}

TEST_F(CliInfo, CheckSaysWhatIsWrongAndWhere) {
  const CommandResult sound = graze({"info", "--check", "--json", "box.off"});
  EXPECT_EQ(sound.exit_code, 0);
  const Json health = Json::parse(sound.out)["health"];
  EXPECT_EQ(health["healthy"], true);
  for (const char* kind :
       {"open_edges", "non_manifold_edges", "turned_edges", "degenerate_triangles",
        "duplicate_triangles", "inside_out_parts", "self_intersections"})
    EXPECT_EQ(health[kind], (Json{{"count", 0}, {"first", Json::array()}})) << kind;

  // A tetrahedron inside out, and a triangle three times.
  write("bad.off",
        "OFF\n7 7 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n9 0 0\n9 1 0\n9 0 1\n"
        "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n3 4 5 6\n3 4 5 6\n3 5 4 6\n");
  const CommandResult result = graze({"info", "--check", "--self", "--json", "box.off", "bad.off"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "");
  const Json report = Json::parse(lines_of(result.out)[1]);
  const Json bad = report["health"];
  EXPECT_EQ(bad["healthy"], false);
  EXPECT_EQ(bad["open_edges"]["count"], 0);
  EXPECT_EQ(bad["non_manifold_edges"]["first"][0],
            (Json{{"vertices", {4, 5}}, {"triangle", 4}, {"triangle_count", 3}, {"line", 14}}));
  EXPECT_EQ(bad["duplicate_triangles"]["first"],
            (Json{{{"triangle", 5}, {"earlier", 4}, {"line", 15}},
                  {{"triangle", 6}, {"earlier", 4}, {"line", 16}}}));
  EXPECT_EQ(bad["inside_out_parts"]["first"],
            (Json{{{"triangle", 0}, {"triangle_count", 4}, {"depth", 0}, {"line", 10}}}));
  EXPECT_EQ(bad["self_intersections"]["first"][2],
            (Json{{"triangle", 5}, {"other", 6}, {"line", 15}}));
  EXPECT_EQ(report["self_intersections"], 3);

  const std::string table = graze({"info", "--check", "bad.off"}).out;
  EXPECT_NE(table.find("  health                  not healthy\n"), std::string::npos) << table;
  EXPECT_NE(
      table.find(
          "  duplicate               2: triangle 5 is 4 (line 15), triangle 6 is 4 (line 16)\n"),
      std::string::npos)
      << table;
  EXPECT_NE(table.find("  inside-out parts        1: the 4 about triangle 0 (line 10)\n"),
            std::string::npos)
      << table;
}

/// What stands in the file where the only faulty triangle is said to be.
TEST_F(CliInfo, CheckNamesTheLineOrTheByteInEveryFormat) {
  write("bad.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n# a square, and a segment\nf 1 2 4 3\n\nf 1 2 2\n");
  write("bad.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 1\n");
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  write("bad.stl", "solid s\n" + facet + "vertex 0 1 0\nendloop\nendfacet\n" + facet +
                       "vertex 1 0 0\nendloop\nendfacet\nendsolid s\n");
  std::string binary(80, ' ');
  binary += std::string("\2\0\0\0", 4) + std::string(2 * 50, '\0');
  binary[84 + 12 + 12 + 3] = 63, binary[84 + 12 + 12 + 2] = '\x80';          // 1 0 0
  binary[84 + 12 + 24 + 4 + 3] = 63, binary[84 + 12 + 24 + 4 + 2] = '\x80';  // 0 1 0
  write("bytes.stl", binary);
  const auto place_in = [&](const std::string& file) {
    const CommandResult result = graze({"info", "--check", "--json", file});
    EXPECT_EQ(result.exit_code, 1) << result.err;
    Json fault = Json::parse(result.out)["health"]["degenerate_triangles"]["first"][0];
    fault.erase("triangle");
    return fault;
  };
  EXPECT_EQ(place_in("bad.obj"), (Json{{"line", 8}}));
  EXPECT_EQ(place_in("bad.ply"), (Json{{"line", 14}}));
  EXPECT_EQ(place_in("bad.stl"), (Json{{"line", 9}}));
  EXPECT_EQ(place_in("bytes.stl"), (Json{{"byte", 134}}));
}

TEST_F(CliInfo, CheckListsTheFirstThousand) {
  write_mesh("row.off", make_row(500));
  const CommandResult result = graze({"info", "--check", "--json", "row.off"});
  EXPECT_EQ(result.exit_code, 1);
  const Json open = Json::parse(result.out)["health"]["open_edges"];
  EXPECT_EQ(open["count"], 1500);
  EXPECT_EQ(open["first"].size(), 1000u);
}

TEST_F(CliInfo, TheTableIsAligned) {
  const CommandResult result = graze({"info", "--fit", "--check", "box.off", "row.off"});
  EXPECT_EQ(result.exit_code, 1);
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_GT(lines.size(), 20u);
  EXPECT_EQ(lines[0], "box.off");
  EXPECT_EQ(lines[1], "  triangles               12");
  EXPECT_EQ(lines[6], "  size (m)                2 4 1");
  EXPECT_EQ(lines[7], "  surface                 closed");
  for (const std::string& line : lines) {
    if (line.starts_with("  ")) {
      EXPECT_NE(line[26], ' ') << line;
    }
  }
}

TEST_F(CliInfo, BadMeshesAreRefusedAndLeaveStdoutEmpty) {
  write("short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  write("mesh.xyz", "1 2 3\n");
  const auto refuse = [&](const std::string& file) {
    const CommandResult result = graze({"info", "box.off", file, "--json"});
    EXPECT_EQ(result.exit_code, 2) << file;
    EXPECT_EQ(result.out, "") << file;
    EXPECT_EQ(lines_of(result.err).size(), 1u) << result.err;
    EXPECT_EQ(result.err.find("graze: " + file + ":"), 0u) << result.err;
    const CommandResult pair = graze({"pair", "box.off", file, "--json"});
    EXPECT_EQ(pair.exit_code, 2) << file;
    EXPECT_EQ(pair.out, "");
    EXPECT_EQ(pair.err, result.err);
  };
  refuse("missing.off");
  refuse("short.off");
  refuse("mesh.xyz");
  std::filesystem::create_directory(folder_ / "folder.off");
  refuse("folder.off");
}

TEST_F(CliInfo, StrangeFileNamesStayOnOneLine) {
  const CommandResult refused = graze({"info", "a\nb.off"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(lines_of(refused.err).size(), 1u);
  EXPECT_EQ(refused.err.find("graze: a\\"), 0u) << refused.err;
  write_mesh("caf\xe9.off", make_box({1, 1, 1}));
  const CommandResult result = graze({"info", "--json", "caf\xe9.off"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Json::parse(result.out)["file"], "caf\xef\xbf\xbd.off");
}

}  // namespace
}  // namespace graze::tests
