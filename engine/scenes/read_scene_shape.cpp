#include <graze/engine/cases/at_place.h>
#include <graze/engine/cases/case_error.h>
#include <graze/engine/cases/inside_folder.h>
#include <graze/engine/cases/read_parts.h>
#include <graze/engine/cases/sha256.h>
#include <graze/engine/mesh/io/file_bytes.h>
#include <graze/engine/mesh/io/source.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/scene_parts.h>

#include <array>
#include <string_view>
#include <vector>

namespace graze::scenes {
namespace {

using cases::at_place;
using cases::JsonCursor;

constexpr std::array<std::string_view, 9> kKinds = {"sphere",      "box",        "capsule",
                                                    "cylinder",    "cone",       "ellipsoid",
                                                    "convex_hull", "half_space", "mesh"};

Eigen::Vector3d read_centre(const JsonCursor& at, const SceneUnits& units) {
  return at.has("centre") ? units.read_point(at.member("centre")) : Eigen::Vector3d(0, 0, 0);
}

Shape read_sphere(const JsonCursor& at, const SceneUnits& units) {
  at.require_keys({"centre", "radius"});
  return Sphere{read_centre(at, units), units.read_length(at.member("radius"))};
}

Shape read_box(const JsonCursor& at, const SceneUnits& units) {
  at.require_keys({"half_extents"});
  return Box{units.read_point(at.member("half_extents"))};
}

Shape read_capsule(const JsonCursor& at, const SceneUnits& units) {
  at.require_keys({"radius", "half_length"});
  return Capsule{units.read_length(at.member("radius")),
                 units.read_length(at.member("half_length"))};
}

template <typename Round>
Shape read_round(const JsonCursor& at, const SceneUnits& units) {
  at.require_keys({"radius", "half_height"});
  return Round{units.read_length(at.member("radius")), units.read_length(at.member("half_height"))};
}

Shape read_ellipsoid(const JsonCursor& at, const SceneUnits& units) {
  at.require_keys({"centre", "semi_axes"});
  return Ellipsoid{read_centre(at, units), units.read_point(at.member("semi_axes"))};
}

Shape read_hull(const JsonCursor& at, const SceneUnits& units) {
  at.require_keys({"points"});
  const JsonCursor list = at.member("points");
  if (list.size() > kMaxHullPoints) {
    list.fail("has " + std::to_string(list.size()) + " points; a hull may have " +
              std::to_string(kMaxHullPoints));
  }
  std::vector<Eigen::Vector3d> points;
  points.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i)
    points.push_back(units.read_point(list.item(i)));
  return ConvexHull(points);
}

Shape read_half_space(const JsonCursor& at, const SceneUnits& units) {
  at.require_keys({"normal", "offset"});
  return HalfSpace{at.member("normal").point(),
                   at.has("offset") ? units.read_length(at.member("offset")) : 0};
}

/// The same mesh with its coordinates in metres.
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
  return cases::sha256_of(mesh_io::read_file(path, name));
}

Shape read_mesh(const JsonCursor& at, const SceneUnits& units, MeshFiles& files) {
  if (at.has("file")) return files.read(at);
  return in_metres(cases::read_inline_mesh(at), units.length);
}

Shape read_kind(const JsonCursor& at, std::string_view kind, const SceneUnits& units,
                MeshFiles& files) {
  if (kind == "sphere") return read_sphere(at, units);
  if (kind == "box") return read_box(at, units);
  if (kind == "capsule") return read_capsule(at, units);
  if (kind == "cylinder") return read_round<Cylinder>(at, units);
  if (kind == "cone") return read_round<Cone>(at, units);
  if (kind == "ellipsoid") return read_ellipsoid(at, units);
  if (kind == "convex_hull") return read_hull(at, units);
  if (kind == "half_space") return read_half_space(at, units);
  return read_mesh(at, units, files);
}

}  // namespace

Mesh MeshFiles::read(const JsonCursor& at) {
  at.require_keys({"file", "unit", "sha256"});
  const JsonCursor place = at.member("file");
  const std::filesystem::path path =
      at_place(place, [&] { return cases::find_inside(folder_, place.text(), "scene"); });
  const LengthUnit unit =
      at.has("unit") ? read_length_unit(at.member("unit")) : LengthUnit{"m", 1, 1};
  if (at.has("sha256")) {
    const JsonCursor hash = at.member("sha256");
    const std::string found = at_place(place, [&] {
      std::string& known = hashes_[path.string()];
      if (known.empty()) known = hash_of(path, mesh_io::printable(place.text()));
      return known;
    });
    if (found != hash.text()) hash.fail("the file has the SHA-256 " + found);
  }
  const std::pair key(path.string(), std::string(unit.name));
  const auto known = loaded_.find(key);
  if (known != loaded_.end()) return known->second;
  Mesh mesh = at_place(place, [&] { return in_metres(load_mesh(path), unit); });
  loaded_.emplace(key, mesh);
  return mesh;
}

Shape read_scene_shape(const JsonCursor& at, const SceneUnits& units, MeshFiles& files) {
  at.require_keys({"name", "sphere", "box", "capsule", "cylinder", "cone", "ellipsoid",
                   "convex_hull", "half_space", "mesh"});
  std::vector<std::string_view> found;
  for (const std::string_view kind : kKinds)
    if (at.has(kind)) found.push_back(kind);
  if (found.size() != 1) {
    at.fail("has " + std::to_string(found.size()) +
            " shapes, not one of sphere, box, capsule, cylinder, cone, ellipsoid, convex_hull, "
            "half_space and mesh");
  }
  const JsonCursor shape = at.member(found.front());
  // What the reader itself refuses has its place already.
  try {
    return read_kind(shape, found.front(), units, files);
  } catch (const CaseError&) {
    throw;
  } catch (const Error& error) {
    shape.fail(error.what());
  }
}

}  // namespace graze::scenes
