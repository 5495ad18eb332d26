#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "data/generator/binary.h"
#include "data/generator/mesh_writers.h"
#include "data/generator/output_file.h"

namespace graze::generator {
namespace {

std::string header(const std::string& name, const Surface& surface, const PlyLayout& layout) {
  const std::string coordinate =
      layout.coordinates == PlyCoordinates::Float ? "property float " : "property double ";
  std::string text = "ply\nformat ";
  switch (layout.encoding) {
    case PlyEncoding::Ascii:
      text += "ascii";
      break;
    case PlyEncoding::LittleEndian:
      text += "binary_little_endian";
      break;
    case PlyEncoding::BigEndian:
      text += "binary_big_endian";
      break;
  }
  text += " 1.0\ncomment " + name + ", metres\nelement vertex " +
          std::to_string(surface.vertices().size()) + '\n';
  for (const char* axis : {"x\n", "y\n", "z\n"})
    text += coordinate + axis;
  text += "element face " + std::to_string(surface.triangles().size()) + "\nproperty list uchar ";
  text += layout.indices == PlyIndices::Ushort ? "ushort" : "uint";
  return text + " vertex_indices\nend_header\n";
}

/// Appends the numbers of a file in the order in which they come.
class PlyBody {
 public:
  PlyBody(std::string& bytes, const PlyLayout& layout) : bytes_(bytes), layout_(layout) {}

  void add_coordinate(double value) {
    if (layout_.coordinates == PlyCoordinates::Float) {
      add(static_cast<float>(value));
    } else {
      add(value);
    }
  }

  void add_index(std::uint32_t value) {
    if (layout_.indices == PlyIndices::Ushort) {
      add(static_cast<std::uint16_t>(value));
    } else {
      add(value);
    }
  }

  void add_count(std::uint8_t value) { add(value); }

  void end_row() {
    if (layout_.encoding == PlyEncoding::Ascii) bytes_.back() = '\n';
  }

 private:
  template <typename Number>
  void add(Number value) {
    switch (layout_.encoding) {
      case PlyEncoding::Ascii:
        bytes_ += shortest(value) + ' ';
        break;
      case PlyEncoding::LittleEndian:
        append_little_endian(bytes_, value);
        break;
      case PlyEncoding::BigEndian:
        append_big_endian(bytes_, value);
        break;
    }
  }

  std::string& bytes_;
  const PlyLayout& layout_;
};

}  // namespace

void write_ply(const std::filesystem::path& path, const Surface& surface, const PlyLayout& layout) {
  constexpr std::size_t kMostUshort = std::numeric_limits<std::uint16_t>::max();
  if (layout.indices == PlyIndices::Ushort && surface.vertices().size() > kMostUshort) {
    throw std::runtime_error(path.string() + ": too many vertices for indices of 16 bits");
  }
  std::string bytes = header(path.stem().string(), surface, layout);
  PlyBody body(bytes, layout);
  for (const Eigen::Vector3d& p : surface.vertices()) {
    for (int i = 0; i < 3; ++i)
      body.add_coordinate(p[i]);
    body.end_row();
  }
  for (const auto& triangle : surface.triangles()) {
    body.add_count(3);
    for (std::uint32_t index : triangle)
      body.add_index(index);
    body.end_row();
  }
  write_file(path, bytes);
}

}  // namespace graze::generator
