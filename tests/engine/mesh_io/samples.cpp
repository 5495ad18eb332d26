#include <tests/engine/mesh_io/samples.h>
#include <cstdint>

namespace graze::mesh_io {
namespace {

constexpr std::array<std::array<double, 3>, 8> kVertices = {{{-0.25, -0.25, -0.25},
                                                             {0.5, -0.25, -0.25},
                                                             {-0.25, 0.5, -0.25},
                                                             {0.5, 0.5, -0.25},
                                                             {-0.25, -0.25, 0.5},
                                                             {0.5, -0.25, 0.5},
                                                             {-0.25, 0.5, 0.5},
                                                             {0.5, 0.5, 0.5}}};

constexpr std::array<std::array<int, 4>, 6> kFaces = {
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

std::string text_of(const std::array<double, 3>& p) {
  const auto digits = [](double value) { return value == 0.5 ? "0.5" : "-2.5e-1"; };
  return std::string(digits(p[0])) + " " + digits(p[1]) + " " + digits(p[2]);
}

std::string text_of(const std::array<int, 4>& face, int first) {
  std::string text;
  for (const int corner : face)
    text.append(" ").append(std::to_string(corner + first));
  return text;
}

/// The corners of the two triangles of each face.
std::vector<std::array<int, 3>> triangles() {
  std::vector<std::array<int, 3>> result;
  for (const auto& f : kFaces) {
    result.push_back({f[0], f[1], f[2]});
    result.push_back({f[0], f[2], f[3]});
  }
  return result;
}

std::string ply_header(const std::string& encoding) {
  return "ply\nformat " + encoding +
         " 1.0\ncomment a cube\nelement vertex 8\nproperty double x\nproperty double y\n"
         "property double z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

std::string cube_obj() {
  std::string text = "# a cube\no cube\n";
  for (const auto& p : kVertices)
    text.append("v ").append(text_of(p)).append("\n");
  for (const auto& face : kFaces)
    text.append("f").append(text_of(face, 1)).append("\n");
  return text;
}

std::string cube_off() {
  std::string text = "OFF\n8 6 12\n";
  for (const auto& p : kVertices)
    text.append(text_of(p)).append("\n");
  for (const auto& face : kFaces)
    text.append("4").append(text_of(face, 0)).append("\n");
  return text;
}

std::string cube_stl_ascii() {
  std::string text = "solid cube\n";
  for (const auto& triangle : triangles()) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const int corner : triangle) {
      text.append("   vertex ")
          .append(text_of(kVertices[static_cast<std::size_t>(corner)]))
          .append("\n");
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid cube\n";
}

std::string cube_stl_binary() {
  std::string bytes = "solid by name, binary by nature";
  bytes.resize(80, ' ');
  append(bytes, std::endian::little, std::uint32_t{12});
  for (const auto& triangle : triangles()) {
    append(bytes, std::endian::little, 0.0f, 0.0f, 1.0f);
    for (const int corner : triangle) {
      for (const double x : kVertices[static_cast<std::size_t>(corner)]) {
        append(bytes, std::endian::little, static_cast<float>(x));
      }
    }
    append(bytes, std::endian::little, std::uint16_t{7});
  }
  return bytes;
}

std::string cube_ply_ascii() {
  std::string text = ply_header("ascii");
  for (const auto& p : kVertices)
    text.append(text_of(p)).append("\n");
  for (const auto& face : kFaces)
    text.append("4").append(text_of(face, 0)).append("\n");
  return text;
}

std::string cube_ply_binary(std::endian order) {
  std::string bytes =
      ply_header(order == std::endian::little ? "binary_little_endian" : "binary_big_endian");
  for (const auto& p : kVertices)
    append(bytes, order, p[0], p[1], p[2]);
  for (const auto& f : kFaces)
    append(bytes, order, std::uint8_t{4}, f[0], f[1], f[2], f[3]);
  return bytes;
}

std::vector<Sample> cubes() {
  return {{"ascii.obj", cube_obj()},
          {"ascii.off", cube_off()},
          {"ascii.stl", cube_stl_ascii()},
          {"binary.stl", cube_stl_binary()},
          {"ascii.ply", cube_ply_ascii()},
          {"little.ply", cube_ply_binary(std::endian::little)},
          {"big.ply", cube_ply_binary(std::endian::big)}};
}

}  // namespace graze::mesh_io
