#include <tests/engine/mesh_io/loading.h>
#include <tests/engine/mesh_io/samples.h>

namespace graze::mesh_io {
namespace {

std::string error(std::string_view bytes) {
  return error_of("a.ply", bytes);
}

const std::string kAscii = "ply\nformat ascii 1.0\n";
const std::string kLittle = "ply\nformat binary_little_endian 1.0\n";
const std::string kVertices =
    "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kEnd = "end_header\n";

TEST(Ply, OtherElementsAndPropertiesAreSkipped) {
  const Mesh mesh = load(
      "a.ply",
      "ply\ncomment a\nformat ascii 1.0\nobj_info b c\nelement camera 2\nproperty float angle\n"
      "property list char float samples\nelement nothing 4000000000\nelement vertex 3\n"
      "property float nx\nproperty list uchar uchar tags\nproperty float x\nproperty float z\n"
      "property uchar red\nproperty float y\nelement edge 1\nproperty int vertex1\n"
      "property int vertex2\nelement face 1\nproperty uchar flags\n"
      "property list uint uint vertex_index\nproperty list uchar float texcoord\nend_header\n"
      "1.5 2 0.5 nan\n1 0\nnan 0 0 9 255 8\n0 2 7 7 1 9 255 8\n0 0 1 9 255 7\n0 1\n\n"
      "0 3 2 1 0 6 0 0 0 1 1 1\n\ncomment the end\n");
  EXPECT_EQ(mesh.vertices()[0], Eigen::Vector3d(0, 8, 9));
  EXPECT_EQ(mesh.vertices()[1], Eigen::Vector3d(1, 8, 9));
  EXPECT_EQ(mesh.triangles()[0], (TriangleIndices{2, 1, 0}));
}

TEST(Ply, FacesMayStandBeforeVertices) {
  const std::string text = kAscii + kFaces + kVertices + kEnd + "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(load("a.ply", text).triangles().size(), 1u);
}

/// One value of each type in front of a coordinate of that type.
template <typename T>
void expect_type_is_read(const std::string& name, std::endian order) {
  std::string bytes = "ply\nformat binary_";
  bytes += order == std::endian::little ? "little" : "big";
  bytes += "_endian 1.0\nelement vertex 3\nproperty " + name + " w\nproperty " + name +
           " x\nproperty " + name + " y\nproperty " + name + " z\nproperty list " +
           (std::is_integral_v<T> ? name : "uchar") + " " + name + " more\nelement face 1\n";
  const std::string index = std::is_integral_v<T> ? name : "int";
  bytes += "property list " + index + " " + index + " vertex_indices\nend_header\n";
  using Index = std::conditional_t<std::is_integral_v<T>, T, int>;
  using Count = std::conditional_t<std::is_integral_v<T>, T, std::uint8_t>;
  const T lowest = std::numeric_limits<T>::lowest();
  const T highest = std::numeric_limits<T>::max();
  append(bytes, order, T{9}, lowest, highest, T{1}, Count{0});
  append(bytes, order, T{9}, T{0}, T{0}, T{0}, Count{2}, T{7}, T{8});
  append(bytes, order, T{9}, T{2}, T{3}, T{4}, Count{1}, T{7});
  append(bytes, order, Index{3}, Index{0}, Index{1}, Index{2});
  const Mesh mesh = load("a.ply", bytes);
  EXPECT_EQ(mesh.vertices()[0],
            Eigen::Vector3d(static_cast<double>(lowest), static_cast<double>(highest), 1))
      << name;
  EXPECT_EQ(mesh.vertices()[2], Eigen::Vector3d(2, 3, 4)) << name;
  EXPECT_EQ(mesh.triangles()[0], (TriangleIndices{0, 1, 2})) << name;
}

TEST(Ply, EveryTypeInBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const std::string name : {"char", "int8"})
      expect_type_is_read<std::int8_t>(name, order);
    for (const std::string name : {"uchar", "uint8"})
      expect_type_is_read<std::uint8_t>(name, order);
    for (const std::string name : {"short", "int16"})
      expect_type_is_read<std::int16_t>(name, order);
    for (const std::string name : {"ushort", "uint16"})
      expect_type_is_read<std::uint16_t>(name, order);
    for (const std::string name : {"int", "int32"})
      expect_type_is_read<std::int32_t>(name, order);
    for (const std::string name : {"uint", "uint32"})
      expect_type_is_read<std::uint32_t>(name, order);
    for (const std::string name : {"float", "float32"})
      expect_type_is_read<float>(name, order);
    for (const std::string name : {"double", "float64"})
      expect_type_is_read<double>(name, order);
  }
}

/// The first byte of the data is a line feed, which must not be taken for the end of a line.
TEST(Ply, BinaryDataBeginRightBehindTheHeader) {
  for (const std::string_view line_end : {"\n", "\r\n", "\r"}) {
    std::string bytes;
    for (const char c : kLittle + "element face 1\nproperty list uchar uchar vertex_indices\n" +
                            kVertices + kEnd) {
      bytes += c == '\n' ? std::string(line_end) : std::string(1, c);
    }
    bytes += "\n";  // a list of ten
    for (char i = 0; i < 10; ++i)
      bytes += static_cast<char>(i % 3);
    for (int i = 0; i < 3; ++i)
      append(bytes, std::endian::little, 1.0 * i, 1.0 * i * i, 0.0);
    EXPECT_EQ(load("a.ply", bytes).triangles().size(), 8u);
  }
}

TEST(Ply, BadHeadersNameTheLine) {
  const struct {
    std::string bytes;
    std::string why;
  } kCases[] = {
      {"Ply\n", "a.ply:1: expected \"ply\""},
      {"\nply\n", "a.ply:1: expected \"ply\""},
      {"ply 2\n", "a.ply:1: unexpected \"2\" at the end of the line"},
      {"ply\n", "a.ply:1: expected \"end_header\", but the file ends"},
      {kAscii + kVertices, "a.ply:6: expected \"end_header\", but the file ends"},
      {"ply\nend_header\n", "a.ply:2: the header has no \"format\""},
      {kAscii + "format ascii 1.0\n", "a.ply:3: a second \"format\""},
      {"ply\nformat\n", "a.ply:2: expected an encoding, but the line ends"},
      {"ply\nformat utf8 1.0\n", "a.ply:2: unknown encoding \"utf8\""},
      {"ply\nformat ascii 1.1\n", "a.ply:2: version \"1.1\" is not supported"},
      {kAscii + "elements 3\n", "a.ply:3: unknown header statement \"elements\""},
      {kAscii + "element vertex\n", "a.ply:3: expected a whole number, but the line ends"},
      {kAscii + "element vertex -1\n", "a.ply:3: the count -1 is negative"},
      {kAscii + "element vertex 1e3\n", "a.ply:3: \"1e3\" is not a whole number"},
      {kAscii + "property int x\n", "a.ply:3: a property before the first element"},
      {kAscii + "element a 1\nproperty int64 x\n", "a.ply:4: unknown type \"int64\""},
      {kAscii + "element a 1\nproperty int\n",
       "a.ply:4: expected the name of a property, but the line ends"},
      {kAscii + "element a 1\nproperty list float int x\n",
       "a.ply:4: the count of a list must be an integer"},
      {kAscii + "element a 1\nelement a 1\n" + kEnd, "a.ply:4: a second element \"a\""},
      {kAscii + "element vertex 1\nproperty int x\nproperty int z\n" + kEnd,
       "a.ply:3: element \"vertex\" has no property y"},
      {kAscii + kVertices + "property int y\n" + kEnd,
       "a.ply:3: element \"vertex\" has more than one property y"},
      {kAscii + "element face 1\nproperty list int int vertices\n" + kEnd,
       "a.ply:3: element \"face\" has no list vertex_indices or vertex_index"},
      {kAscii + kFaces + "property list int int vertex_index\n" + kEnd,
       "a.ply:3: element \"face\" has more than one list vertex_indices or vertex_index"},
      {kAscii + "element face 1\nproperty list int float vertex_index\n",
       "a.ply:4: the corners of a face must be integers"},
      {kAscii + "element tristrips 1\nproperty list int int vertex_indices\n",
       "a.ply:4: element \"tristrips\" is not supported, corners are read from element \"face\" "
       "alone"},
  };
  for (const auto& c : kCases)
    EXPECT_EQ(error(c.bytes), c.why) << c.bytes;
}

TEST(Ply, BadTextNamesTheLine) {
  const std::string head = kAscii + kVertices + kFaces + kEnd;
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  const struct {
    std::string bytes;
    std::string why;
  } kCases[] = {
      {head + "0 0 0\n", "a.ply:10: the file ends after 1 of 3 rows of element \"vertex\""},
      {head + "0 0\n0 0 0\n", "a.ply:10: expected a number, but the line ends"},
      {head + "0 0 0 0\n", "a.ply:10: unexpected \"0\" at the end of the line"},
      {head + vertices, "a.ply:12: the file ends after 0 of 1 rows of element \"face\""},
      {head + vertices + "3 0 1 3\n",
       "a.ply:13: index 3 is out of range, there are 3 vertices counted from 0"},
      {head + vertices + "3 0 1 -1\n",
       "a.ply:13: index -1 is out of range, there are 3 vertices counted from 0"},
      {head + vertices + "3 0 1 2.0\n", "a.ply:13: \"2.0\" is not a whole number"},
      {head + vertices + "3 0 1\n", "a.ply:13: expected a whole number, but the line ends"},
      {head + vertices + "2 0 1\n", "a.ply:13: a polygon needs at least 3 corners, this has 2"},
      {head + vertices + "-3 0 1 2\n", "a.ply:13: the count -3 of a list is negative"},
      {head + vertices + "2147483648 0 1 2\n",
       "a.ply:13: expected a whole number, but the line ends"},
      {head + vertices + "3 0 1 2 0\n", "a.ply:13: unexpected \"0\" at the end of the line"},
      {head + vertices + "3 0 1 2\n0\n", "a.ply:14: unexpected \"0\" after the last row"},
      {kAscii + "element a 1\nproperty list int int b\n" + kEnd + "3 1 1\n",
       "a.ply:6: expected a number, but the line ends"},
  };
  for (const auto& c : kCases)
    EXPECT_EQ(error(c.bytes), c.why) << c.bytes;
}

TEST(Ply, BadDataNameTheByte) {
  const std::string header = kLittle + kVertices + kFaces + kEnd;
  const auto at = [&](std::size_t offset) {
    return "a.ply: byte " + std::to_string(header.size() + offset) + ": ";
  };
  std::string vertices;
  for (int i = 0; i < 3; ++i)
    append(vertices, std::endian::little, 1.0 * i, 1.0 * i * i, 0.0);
  const auto with_face = [&](std::uint8_t count, auto... corners) {
    std::string bytes = header + vertices;
    append(bytes, std::endian::little, count, corners...);
    return bytes;
  };
  EXPECT_EQ(error(header + vertices.substr(0, 71)),
            at(0) + "3 rows of element \"vertex\" need at least 24 bytes each, but 71 follow");
  EXPECT_EQ(error(header + vertices),
            at(72) + "1 rows of element \"face\" need at least 1 bytes each, but 0 follow");
  EXPECT_EQ(error(with_face(3, 0, 1)), at(81) + "the file ends within a value");
  EXPECT_EQ(error(with_face(3, 0, 1, 3)),
            at(81) + "index 3 is out of range, there are 3 vertices counted from 0");
  EXPECT_EQ(error(with_face(2, 0, 1)), at(72) + "a polygon needs at least 3 corners, this has 2");
  EXPECT_EQ(error(with_face(3, 0, 1, 2, 0)), at(85) + "4 bytes follow the last row");
  std::string infinite = header;
  append(infinite, std::endian::little, 0.0, std::numeric_limits<double>::quiet_NaN());
  infinite.resize(header.size() + 100);
  EXPECT_EQ(error(infinite), at(8) + "a coordinate is not finite");
  const std::string list = kLittle + "element a 1\nproperty list uint double b\n" + kEnd;
  EXPECT_EQ(error(list + "\xff\xff\xff\xff"),
            "a.ply: byte " + std::to_string(list.size() + 4) + ": the file ends within a list");
  const std::string negative = kLittle + "element a 1\nproperty list char double b\n" + kEnd;
  EXPECT_EQ(error(negative + "\xff"), "a.ply: byte " + std::to_string(negative.size() + 1) +
                                          ": the count -1 of a list is negative");
}

}  // namespace
}  // namespace graze::mesh_io
