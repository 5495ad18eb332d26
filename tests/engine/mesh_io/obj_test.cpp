#include <tests/engine/mesh_io/loading.h>

namespace graze::mesh_io {
namespace {

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::vector<TriangleIndices> triangles(std::string_view bytes) {
  const Mesh mesh = load("a.obj", bytes);
  return {mesh.triangles().begin(), mesh.triangles().end()};
}

std::vector<TriangleIndices> faces(std::string_view faces) {
  return triangles(std::string(kTriangle) + std::string(faces));
}

std::string error(std::string_view bytes) {
  return error_of("a.obj", bytes);
}

TEST(Obj, CornersMayHaveTextureCoordinatesAndNormals) {
  const std::vector<TriangleIndices> expected = {{0, 1, 2}};
  for (const std::string_view face :
       {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//2 3//3", "f 1/1/1 2/2/2 3/3/3", "f 1/-1/-1 2/-2 3",
        "  f\t1/ 2// 3/", "f +1 2 3", "f 1 2 3 # a comment", "fo 1 2 3"}) {
    EXPECT_EQ(faces(face), expected) << face;
  }
}

TEST(Obj, NegativeIndicesCountFromTheEnd) {
  EXPECT_EQ(faces("f -3 -2 -1\nv 2 2 2\nf -4/-1 -1 -2//-7\n"),
            (std::vector<TriangleIndices>{{0, 1, 2}, {0, 3, 2}}));
}

TEST(Obj, CountsInTheFirstLineMustBeTrue) {
  const std::string rest = std::string(kTriangle) + "f 1 2 3\n";
  EXPECT_EQ(triangles("# a comment\n3 1\n" + rest), (std::vector<TriangleIndices>{{0, 1, 2}}));
  EXPECT_EQ(error("4 1\n" + rest), "a.obj:5: the first line announces 4 vertices, there are 3");
  EXPECT_EQ(error("3 0\n" + rest), "a.obj:5: the first line announces 0 faces, there are 1");
  EXPECT_NE(error("3\n" + rest).find("a.obj:1: "), std::string::npos);
  EXPECT_NE(error("3 1 1\n" + rest).find("a.obj:1: "), std::string::npos);
  EXPECT_EQ(error(rest + "3 1\n"), "a.obj:5: unknown statement \"3\"") << "not the first line";
}

TEST(Obj, FacesMayNameVerticesToCome) {
  EXPECT_EQ(triangles("f 1 2 3 4\nf 1 3 4\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 3 2 1\nv 0 1 0"),
            (std::vector<TriangleIndices>{{0, 1, 2}, {0, 2, 3}, {0, 2, 3}, {2, 1, 0}}));
  // A dart is not fanned outside itself, though its corners are not known when it is read.
  const std::string dart = "v 4 0 0\nv 1 1 0\nv 0 4 0\nv 0 0 0\n";
  const std::string face = "f 1 2 3 4\n";
  EXPECT_EQ(triangles(face + dart), triangles(dart + face));
  EXPECT_NE(triangles(face + dart)[0], (TriangleIndices{0, 1, 2}));
}

TEST(Obj, VerticesMayHaveWeightsOrColours) {
  const Mesh mesh = load("a.obj", "v 0 0 0 1\nv 1 2 3 0.5 0.5 0.5\nv 4 5 6 1 1 1 1\nf 1 2 3");
  EXPECT_EQ(mesh.vertices()[1], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(mesh.vertices().size(), 3u);
}

TEST(Obj, ABackslashContinuesALine) {
  EXPECT_EQ(triangles("v 0 0 \\\n0\nv 1\\\n 0 0\\\r\n\nv 0 1 0\nf 1 2\\\n3\\\n\\\n 1\n").size(),
            2u);
  EXPECT_EQ(triangles("o name \\\nv 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").size(), 1u);
}

TEST(Obj, ABackslashInACommentContinuesNothing) {
  EXPECT_EQ(faces("# C:\\\nf 1 2 3\n").size(), 1u);
}

TEST(Obj, StatementsWithoutASurfaceAreSkipped) {
  EXPECT_EQ(
      faces("vt nan 0\nvn nan nan nan\nvp 0 0\ng a b\no\ns off\nmg 1 2\nusemtl m\nmtllib a b\n"
            "maplib a\nusemap b\nbevel on\nc_interp on\nd_interp on\nlod 3\nshadow_obj a\n"
            "trace_obj b\np 1 2\nl 1 2 3\nctech cparm 1\nstech cspace 1\n\n#\nf 1 2 3")
          .size(),
      1u);
}

TEST(Obj, BadFilesNameTheLine) {
  const std::string v(kTriangle);
  const struct {
    std::string bytes;
    std::string why;
  } kCases[] = {
      {"v 0 0 0\nV 1 0 0\n", "a.obj:2: unknown statement \"V\""},
      {v + "face 1 2 3\n", "a.obj:4: unknown statement \"face\""},
      {v + "surf 0 1 0 1 1 2 3\n", "a.obj:4: free-form statement \"surf\" is not supported"},
      {v + "\n\ncstype bezier\n", "a.obj:6: free-form statement \"cstype\" is not supported"},
      {v + "call other.obj\n",
       "a.obj:4: statement \"call\" goes outside the file, which is not supported"},
      {v + "bzp 1 2 3\n", "a.obj:4: free-form statement \"bzp\" is not supported"},
      {"v 0 0\nv 1 0 0", "a.obj:1: expected a number, but the line ends"},
      {"v 0 0", "a.obj:1: expected a number, but the file ends"},
      {"v 0 0 # 0\n", "a.obj:1: expected a number, but the line ends"},
      {"v 0 0 0 v 1 0 0\n", "a.obj:1: \"v\" is not a finite number"},
      {"v 0 0 \\\n\\\nz\n", "a.obj:3: \"z\" is not a finite number"},
      {v + "f 1 2\n", "a.obj:4: a polygon needs at least 3 corners, this has 2"},
      {v + "f\n", "a.obj:4: a polygon needs at least 3 corners, this has 0"},
      {v + "f 1 2 \\\n\n", "a.obj:4: a polygon needs at least 3 corners, this has 2"},
      {v + "f 1 2 0\n", "a.obj:4: index 0 is out of range, there are 3 vertices counted from 1"},
      {v + "f 1 2 -4\n", "a.obj:4: index -4 is out of range, there are 3 vertices so far"},
      {v + "f 1 2 4\n", "a.obj:4: index 4 is out of range, there are 3 vertices counted from 1"},
      {v + "f 1 4 \\\n 5\nv 0 0 0\n",
       "a.obj:4: index 5 is out of range, there are 4 vertices counted from 1"},
      {v + "f 1 2 2147483648\n",
       "a.obj:4: index 2147483648 is out of range, there are 3 vertices counted from 1"},
      {v + "f 1 2 99999999999999999999\n",
       "a.obj:4: \"99999999999999999999\" is not a corner of a face"},
      {v + "f 1 2 -9223372036854775808\n",
       "a.obj:4: index -9223372036854775808 is out of range, there are 3 vertices so far"},
      {v + "f 1 2 3.0\n", "a.obj:4: \"3.0\" is not a corner of a face"},
      {v + "f 1 2 3/1/1/1\n", "a.obj:4: \"3/1/1/1\" is not a corner of a face"},
      {v + "f 1 2 3/a\n", "a.obj:4: \"3/a\" is not a corner of a face"},
      {v + "f 1 2 /3\n", "a.obj:4: \"/3\" is not a corner of a face"},
      {v + "f 1 2 +-3\n", "a.obj:4: \"+-3\" is not a corner of a face"},
      {v + "f 1 2 3 \\", "a.obj:4: \"\\\" is not a corner of a face"},
      {v + "f 1 2 3\\ \n", "a.obj:4: \"3\\\" is not a corner of a face"},
  };
  for (const auto& c : kCases)
    EXPECT_EQ(error(c.bytes), c.why) << c.bytes;
}

}  // namespace
}  // namespace graze::mesh_io
