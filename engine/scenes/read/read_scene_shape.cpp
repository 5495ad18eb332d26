#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/inside_folder.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/file_bytes.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/scenes/read/scene_parts.h>

#include <string>
#include <utility>
#include <vector>

namespace graze::scenes {
namespace {

using cases::at_place;
using cases::JsonCursor;

/// Returns the same mesh with its coordinates in metres.
Mesh in_metres(const Mesh& mesh, const LengthUnit& unit) {
  if (unit.metres == 1 && unit.per_metre == 1) return mesh;
  std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& v : vertices) {
    for (int i = 0; i < 3; ++i)
      v.data()[i] = unit.to_metres(v.data()[i]);
  }
  return Mesh(vertices, mesh.triangles());
}

std::string hash_of(const std::filesystem::path& path, const std::string& name) {
  mesh_io::require_regular_file(path, name);
  return files::sha256_of(mesh_io::read_file(path, name));
}

}  // namespace

/// Returns the path to what "file" names, if its bytes have the "sha256" that may be there.
std::filesystem::path MeshFiles::find(const JsonCursor& at) {
  const JsonCursor place = at.member("file");
  std::filesystem::path path =
      at_place(place, [&] { return cases::find_inside(folder_, place.text(), "scene"); });
  if (at.has("sha256")) {
    const JsonCursor hash = at.member("sha256");
    const std::string found = at_place(place, [&] {
      std::string& known = hashes_[path.string()];
      if (known.empty()) known = hash_of(path, mesh_io::printable(place.text()));
      return known;
    });
    if (found != hash.text()) hash.fail("the file has the SHA-256 " + found);
  }
  return path;
}

std::string MeshFiles::read_bytes(const JsonCursor& at) {
  const std::filesystem::path path = find(at);
  const JsonCursor place = at.member("file");
  return at_place(place, [&] {
    const std::string name = mesh_io::printable(place.text());
    mesh_io::require_regular_file(path, name);
    return mesh_io::read_file(path, name);
  });
}

Mesh MeshFiles::read(const JsonCursor& at) {
  at.require_keys({"file", "unit", "sha256"});
  const std::filesystem::path path = find(at);
  const LengthUnit unit =
      at.has("unit") ? read_length_unit(at.member("unit")) : LengthUnit{"m", 1, 1};
  const std::pair key(path.string(), std::string(unit.name));
  const auto known = loaded_.find(key);
  if (known != loaded_.end()) return known->second;
  Mesh mesh = at_place(at.member("file"), [&] { return in_metres(load_mesh(path), unit); });
  loaded_.emplace(key, mesh);
  return mesh;
}

Shape read_scene_shape(const JsonCursor& at, const SceneUnits& units, MeshFiles& files) {
  at.require_keys({"name", "sphere", "box", "capsule", "cylinder", "cone", "ellipsoid",
                   "convex_hull", "half_space", "plane", "mesh", "height_field"});
  // Cases, which have all other kinds, have no height fields.
  if (at.has("height_field")) {
    at.require_keys({"name", "height_field"});
    return read_height_field(at.member("height_field"), units, files);
  }
  return cases::read_body_shape(
      at, {.length = [&](const JsonCursor& length) { return units.read_length(length); },
           .mesh =
               [&](const JsonCursor& mesh) {
                 if (mesh.has("file")) return files.read(mesh);
                 return in_metres(cases::read_inline_mesh(mesh), units.length);
               }});
}

}  // namespace graze::scenes
