#include <graze/bvh/error.h>
#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/read_case.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace graze::cases {
namespace {

constexpr std::array<std::string_view, 10> kKinds = {
    "sphere",    "box",         "capsule",    "cylinder", "cone",
    "ellipsoid", "convex_hull", "half_space", "plane",    "mesh"};

Eigen::Vector3d read_point(const JsonCursor& at, const BodyShapeReader& reader) {
  at.require_size(3);
  Eigen::Vector3d point;
  for (std::size_t i = 0; i < 3; ++i)
    point.data()[i] = reader.length(at.item(i));
  return point;
}

Eigen::Vector3d read_centre(const JsonCursor& at, const BodyShapeReader& reader) {
  return at.has("centre") ? read_point(at.member("centre"), reader) : Eigen::Vector3d(0, 0, 0);
}

Shape read_sphere(const JsonCursor& at, const BodyShapeReader& reader) {
  at.require_keys({"centre", "radius"});
  return Sphere{read_centre(at, reader), reader.length(at.member("radius"))};
}

Shape read_box(const JsonCursor& at, const BodyShapeReader& reader) {
  at.require_keys({"half_extents"});
  return Box{read_point(at.member("half_extents"), reader)};
}

Shape read_capsule(const JsonCursor& at, const BodyShapeReader& reader) {
  at.require_keys({"radius", "half_length"});
  return Capsule{reader.length(at.member("radius")), reader.length(at.member("half_length"))};
}

template <typename Round>
Shape read_round(const JsonCursor& at, const BodyShapeReader& reader) {
  at.require_keys({"radius", "half_height"});
  return Round{reader.length(at.member("radius")), reader.length(at.member("half_height"))};
}

Shape read_ellipsoid(const JsonCursor& at, const BodyShapeReader& reader) {
  at.require_keys({"centre", "semi_axes"});
  return Ellipsoid{read_centre(at, reader), read_point(at.member("semi_axes"), reader)};
}

Shape read_hull(const JsonCursor& at, const BodyShapeReader& reader) {
  at.require_keys({"points"});
  const JsonCursor list = at.member("points");
  if (list.size() > kMaxHullPoints) {
    list.fail("has " + std::to_string(list.size()) + " points; a hull may have " +
              std::to_string(kMaxHullPoints));
  }
  std::vector<Eigen::Vector3d> points;
  points.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i)
    points.push_back(read_point(list.item(i), reader));
  return ConvexHull(points);
}

template <typename Flat>
Shape read_flat(const JsonCursor& at, const BodyShapeReader& reader) {
  at.require_keys({"normal", "offset"});
  return Flat{at.member("normal").point(),
              at.has("offset") ? reader.length(at.member("offset")) : 0};
}

Shape read_kind(const JsonCursor& at, std::string_view kind, const BodyShapeReader& reader) {
  if (kind == "sphere") return read_sphere(at, reader);
  if (kind == "box") return read_box(at, reader);
  if (kind == "capsule") return read_capsule(at, reader);
  if (kind == "cylinder") return read_round<Cylinder>(at, reader);
  if (kind == "cone") return read_round<Cone>(at, reader);
  if (kind == "ellipsoid") return read_ellipsoid(at, reader);
  if (kind == "convex_hull") return read_hull(at, reader);
  if (kind == "half_space") return read_flat<HalfSpace>(at, reader);
  if (kind == "plane") return read_flat<Plane>(at, reader);
  return reader.mesh(at);
}

}  // namespace

Shape read_body_shape(const JsonCursor& at, const BodyShapeReader& reader) {
  std::vector<std::string_view> found;
  for (const std::string_view kind : kKinds)
    if (at.has(kind)) found.push_back(kind);
  if (found.size() != 1) {
    at.fail("has " + std::to_string(found.size()) +
            " shapes, not one of sphere, box, capsule, cylinder, cone, ellipsoid, convex_hull, "
            "half_space, plane and mesh");
  }
  const JsonCursor shape = at.member(found.front());
  // What the reader itself refuses names its place already.
  try {
    return read_kind(shape, found.front(), reader);
  } catch (const CaseError&) {
    throw;
  } catch (const Error& error) {
    shape.fail(error.what());
  }
}

}  // namespace graze::cases
