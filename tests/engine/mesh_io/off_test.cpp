#include <tests/engine/mesh_io/loading.h>

namespace graze::mesh_io {
namespace {

std::string error(std::string_view bytes) {
  return error_of("a.off", bytes);
}

TEST(Off, HeadersOfAllKinds) {
  const std::string rest = "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const std::string_view header :
       {"OFF\n3 1 3", "OFF 3 1 3", "OFF3 1 3", "OFF\n3 1", "# c\n\nOFF # c\n# c\n\n3 1 0 # c\n#c",
        "COFF\n3 1 0", "NOFF\n3 1 0", "CNOFF\n3 1 0", "STOFF\n3 1 0", "STCNOFF 3 1 0"}) {
    const Mesh mesh = load("a.off", std::string(header) + rest);
    EXPECT_EQ(mesh.vertices().size(), 3u) << header;
    EXPECT_EQ(mesh.triangles().size(), 1u) << header;
  }
}

TEST(Off, ColoursAndNormalsAreSkipped) {
  const Mesh mesh =
      load("a.off",
           "CNOFF\n4 2 0\n0 0 0 0 0 1 255 0 0 255\n1 0 0 nan nan nan 0 0 0 0\n"
           "1 1 0 0 0 1 # c\n0 1 0 0 0 1\n\n4 0 1 2 3 255 0 0\n3 2 1 0 0.5 0.5 0.5 1\n# end");
  EXPECT_EQ(mesh.triangles().size(), 3u);
  EXPECT_EQ(mesh.vertices()[2], Eigen::Vector3d(1, 1, 0));
}

TEST(Off, BadFilesNameTheLine) {
  const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const struct {
    std::string bytes;
    std::string why;
  } kCases[] = {
      {"off\n3 1 0\n", "a.off:1: expected \"OFF\", found \"off\""},
      {"\n\n3 1 0\n", "a.off:3: expected \"OFF\", found \"3\""},
      {"XOFF 3 1 0\n", "a.off:1: expected \"OFF\", found \"XOFF\""},
      {"# nothing\n", "a.off:1: expected \"OFF\", but the file ends"},
      {"4OFF\n3 1 0\n",
       "a.off:1: vertices that are not in three dimensions (\"4OFF\") are not supported"},
      {"nOFF\n3\n3 1 0\n",
       "a.off:1: vertices that are not in three dimensions (\"nOFF\") are not supported"},
      {"OFF BINARY\n", "a.off:1: binary OFF is not supported"},
      {"OFF\n", "a.off:1: expected the counts of vertices and faces, but the file ends"},
      {"OFF\n3\n", "a.off:2: expected a whole number, but the line ends"},
      {"OFF\n3 1.5 0\n", "a.off:2: \"1.5\" is not a whole number"},
      {"OFF\n-3 1 0\n", "a.off:2: the count -3 is negative"},
      {"OFF\n3 1 0 0\n", "a.off:2: unexpected \"0\" at the end of the line"},
      {"OFF\n99999999999999999999 1 0\n", "a.off:2: \"99999999999999999999\" is too large"},
      {"OFF\n4294967295 1 0\n0 0 0\n", "a.off:3: the file ends after 1 of 4294967295 vertices"},
      {"OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n", "a.off:4: expected a number, but the line ends"},
      {head, "a.off:5: the file ends after 0 of 1 faces"},
      {head + "3 0 1\n", "a.off:6: expected a whole number, but the line ends"},
      {head + "2 0 1\n", "a.off:6: a polygon needs at least 3 corners, this has 2"},
      {head + "-1 0 1 2\n", "a.off:6: the count -1 is negative"},
      {head + "3 0 1 3\n", "a.off:6: index 3 is out of range, there are 3 vertices counted from 0"},
      {head + "3 0 1 -1\n",
       "a.off:6: index -1 is out of range, there are 3 vertices counted from 0"},
      {head + "4000000000 0 1 2\n", "a.off:6: expected a whole number, but the line ends"},
      {head + "3 0 1 2\n3 0 1 2\n", "a.off:7: unexpected \"3\" after the last face"},
  };
  for (const auto& c : kCases)
    EXPECT_EQ(error(c.bytes), c.why) << c.bytes;
}

}  // namespace
}  // namespace graze::mesh_io
