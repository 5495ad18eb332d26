#include "data/generator/mesh_writers.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "data/generator/binary.h"
#include "data/generator/output_file.h"

namespace graze::generator {
namespace {

std::string coordinates(const Eigen::Vector3d& p) {
  return shortest(p.x()) + ' ' + shortest(p.y()) + ' ' + shortest(p.z());
}

}  // namespace

void write_obj(const std::filesystem::path& path, const Surface& surface) {
  std::string text = "# " + path.stem().string() + ", metres\n";
  for (const Eigen::Vector3d& p : surface.vertices())
    text += "v " + coordinates(p) + '\n';
  for (const auto& [a, b, c] : surface.triangles()) {
    text += "f " + std::to_string(a + 1) + ' ' + std::to_string(b + 1) + ' ' +
            std::to_string(c + 1) + '\n';
  }
  write_file(path, text);
}

void write_off(const std::filesystem::path& path, const Surface& surface) {
  std::string text = "OFF\n" + std::to_string(surface.vertices().size()) + ' ' +
                     std::to_string(surface.triangles().size()) + " 0\n";
  for (const Eigen::Vector3d& p : surface.vertices())
    text += coordinates(p) + '\n';
  for (const auto& [a, b, c] : surface.triangles()) {
    text += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
  }
  write_file(path, text);
}

void write_binary_stl(const std::filesystem::path& path, const Surface& surface) {
  std::string bytes = path.stem().string() + ", metres";
  bytes.resize(80, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(surface.triangles().size()));
  for (const auto& [a, b, c] : surface.triangles()) {
    const Eigen::Vector3d& p = surface.vertices()[a];
    const Eigen::Vector3d normal =
        (surface.vertices()[b] - p).cross(surface.vertices()[c] - p).normalized();
    for (const Eigen::Vector3d& v : {normal, p, surface.vertices()[b], surface.vertices()[c]}) {
      for (int i = 0; i < 3; ++i)
        append_little_endian(bytes, static_cast<float>(v[i]));
    }
    bytes.append(2, '\0');
  }
  write_file(path, bytes);
}

}  // namespace graze::generator
