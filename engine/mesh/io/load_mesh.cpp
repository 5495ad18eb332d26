#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/io/file_bytes.h>
#include <graze/engine/mesh/io/format.h>
#include <graze/engine/mesh/load_mesh.h>
#include <string>
#include <utility>

namespace graze {
namespace {

using mesh_io::Format;
using mesh_io::MeshArrays;

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

}  // namespace

Mesh load_mesh(const std::filesystem::path& path) {
  return bvh::in_standard_arithmetic([&]() -> Mesh {
    const std::string name = mesh_io::printable(path.string());
    mesh_io::require_regular_file(path, name);
    const Format& format = format_of(path, name);
    MeshArrays arrays;
    {
      const std::string bytes = mesh_io::read_file(path, name);
      arrays = format.read({name, bytes});
    }
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
