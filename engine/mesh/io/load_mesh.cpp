#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/io/file_bytes.h>
#include <graze/engine/mesh/io/format.h>
#include <graze/engine/mesh/load_mesh.h>
#include <string>
#include <utility>
#include <vector>

namespace graze {
namespace {

using mesh_io::Format;
using mesh_io::MeshArrays;
using mesh_io::ReadSettings;

const Format& format_of(const std::filesystem::path& path, const std::string& name) {
  const std::string extension = path.extension().string();
  const Format* format = mesh_io::find_format(extension);
  if (format != nullptr) return *format;
  std::string why =
      extension.empty() ? "no extension" : "unknown extension " + mesh_io::quoted(extension);
  why += ", known are";
  for (const Format& known : mesh_io::all_formats()) {
    why += ' ';
    why += known.extension;
  }
  mesh_io::fail({name, {}}, why);
}

MeshArrays read_arrays(const std::filesystem::path& path, const std::string& name,
                       const ReadSettings& settings) {
  mesh_io::require_regular_file(path, name);
  const Format& format = format_of(path, name);
  const std::string bytes = mesh_io::read_file(path, name);
  return format.read({name, bytes}, settings);
}

}  // namespace

std::vector<mesh_io::Place> mesh_io::find_triangle_places(const std::filesystem::path& path) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<Place> {
    return read_arrays(path, printable(path.string()), {.has_places = true}).places;
  });
}

Mesh load_mesh(const std::filesystem::path& path) {
  return bvh::in_standard_arithmetic([&]() -> Mesh {
    const std::string name = mesh_io::printable(path.string());
    const MeshArrays arrays = read_arrays(path, name, {});
    try {
      return Mesh(arrays.vertices, arrays.triangles);
    } catch (const MeshError& error) {
      ErrorPlace place = error.place();
      place.file = name;
      throw MeshError(name + ": " + error.what(), std::move(place));
    }
  });
}

}  // namespace graze
