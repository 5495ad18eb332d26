#include <graze/engine/mesh/io/position_index.h>
#include <tests/engine/mesh_io/loading.h>
#include <tests/engine/mesh_io/samples.h>

namespace graze::mesh_io {
namespace {

std::string error(std::string_view bytes) {
  return error_of("a.stl", bytes);
}

constexpr std::string_view kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TEST(StlAscii, LayoutAndCapitalsDoNotMatter) {
  EXPECT_EQ(load("a.stl",
                 "SOLID x\nFacet Normal 0 0 0 Outer Loop vertex 0 0 0 vertex\n\n1 0 0\t"
                 "VERTEX 0 1 0 endloop ENDFACET\rEndSolid")
                .triangles()
                .size(),
            1u);
}

TEST(StlAscii, SeveralSolidsAreOneMesh) {
  const std::string solid = "solid facet normal\n" + std::string(kFacet) + "endsolid facet\n\n";
  const Mesh mesh = load("a.stl", solid + solid);
  EXPECT_EQ(mesh.triangles().size(), 2u);
  EXPECT_EQ(mesh.vertices().size(), 3u);
}

TEST(StlAscii, NormalsAreSkippedWhateverTheySay) {
  std::string facet(kFacet);
  facet.replace(facet.find("0 0 1"), 5, "nan -nan(ind) x");
  EXPECT_EQ(load("a.stl", "solid\n" + facet + "endsolid").triangles().size(), 1u);
}

TEST(StlAscii, BadFilesNameTheLine) {
  const std::string facet(kFacet);
  const struct {
    std::string bytes;
    std::string why;
  } kCases[] = {
      {"solid", "a.stl:1: expected \"facet\" or \"endsolid\", but the file ends"},
      {"solid x\n" + facet, "a.stl:8: expected \"facet\" or \"endsolid\", but the file ends"},
      {"solid x\n" + facet + "end", "a.stl:9: expected \"facet\" or \"endsolid\", found \"end\""},
      {"solid x\n" + facet + "endsolid\n" + facet, "a.stl:10: expected \"solid\", found \"facet\""},
      {"solid x\nfacet\n", "a.stl:2: expected \"normal\", but the file ends"},
      {"solid x\nfacet normal 0 0\n", "a.stl:2: expected a number, but the file ends"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1",
       "a.stl:5: expected a number, but the file ends"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nendloop\n",
       "a.stl:6: expected \"vertex\", found \"endloop\""},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0 0\n",
       "a.stl:4: expected \"vertex\", found \"0\""},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 1 0\nvertex",
       "a.stl:7: expected \"endloop\", found \"vertex\""},
      {"solid \xff\n\nfacet normal 0 0 1\nouter loop\nvertex 0 0 \xff",
       "a.stl:5: \"\\xff\" is not a finite number"},
  };
  for (const auto& c : kCases)
    EXPECT_EQ(error(c.bytes), c.why) << c.bytes;
}

TEST(StlBinary, FloatsAreWidenedExactly) {
  std::string bytes(80, 'x');
  append(bytes, std::endian::little, std::uint32_t{1}, 0.0f, 0.0f, 0.0f);
  append(bytes, std::endian::little, 0.1f, 1e-45f, -0.0f, 3.4028235e38f, 0.0f, 0.0f, 0.1f, 1e-45f,
         0.0f);
  append(bytes, std::endian::little, std::uint16_t{0xffff});
  const Mesh mesh = load("a.stl", bytes);
  ASSERT_EQ(mesh.vertices().size(), 3u);
  EXPECT_EQ(mesh.vertices()[0].x(), double{0.1f});
  EXPECT_EQ(mesh.vertices()[0].y(), std::ldexp(1.0, -149));
  EXPECT_TRUE(std::signbit(mesh.vertices()[0].z()));
  EXPECT_FALSE(std::signbit(mesh.vertices()[2].z()));
  EXPECT_EQ(mesh.vertices()[1].x(), double{std::numeric_limits<float>::max()});
}

TEST(StlBinary, BadFilesNameTheByte) {
  const std::string cube = cube_stl_binary();
  EXPECT_EQ(error(cube + "x"),
            "a.stl: byte 80: as binary STL, 12 triangles need 600 bytes, but 601 follow");
  EXPECT_EQ(error(cube.substr(0, 683)),
            "a.stl: byte 80: as binary STL, 12 triangles need 600 bytes, but 599 follow");
  std::string claim = cube;
  claim.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(error(claim),
            "a.stl: byte 80: as binary STL, 4294967295 triangles need 214748364750 bytes, but 600 "
            "follow");
  std::string infinite = cube;
  infinite.replace(84 + 50 + 12 + 8, 4, std::string_view("\0\0\x80\x7f", 4));
  EXPECT_EQ(error(infinite), "a.stl: byte 154: a coordinate is not finite");
  EXPECT_EQ(
      error("binary"),
      "a.stl: neither text that begins with \"solid\" nor the 84 bytes of a binary STL's header");
  EXPECT_EQ(error("solidity" + std::string(76, ' ')),
            "a.stl: byte 80: as binary STL, 538976288 triangles need "
            "26948814400 bytes, but 0 follow");
}

TEST(PositionIndex, BitEqualPositionsAreOne) {
  PositionIndex positions;
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 10000; ++i) {
      EXPECT_EQ(positions.add(Eigen::Vector3d(i % 100, i / 100, 0.5)),
                static_cast<std::uint32_t>(i));
    }
  }
  EXPECT_EQ(positions.add({0, 0, -0.5}), 10000u);
  EXPECT_EQ(positions.add({-0.0, 0, 0.5}), 10001u);
  EXPECT_EQ(positions.take_positions().size(), 10002u);
}

}  // namespace
}  // namespace graze::mesh_io
