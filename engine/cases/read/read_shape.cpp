#include <graze/engine/cases/case_mesh_file.h>
#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shape_bounds.h>

#include <limits>
#include <string>
#include <vector>

namespace graze::cases {
namespace {

Triangle read_triangle(const JsonCursor& at) {
  at.require_size(3);
  return {at.item(0).point(), at.item(1).point(), at.item(2).point()};
}

Aabb read_box(const JsonCursor& at) {
  at.require_keys({"min", "max"});
  Aabb box{at.member("min").point(), at.member("max").point()};
  at_place(at, [&] { check_box(box, "the box"); });
  return box;
}

Obb read_obb(const JsonCursor& at) {
  at.require_keys({"pose", "half_extents"});
  Obb box{read_pose(at.member("pose")), at.member("half_extents").point()};
  at_place(at, [&] { check_box(box, "the box"); });
  return box;
}

Sphere read_sphere(const JsonCursor& at) {
  at.require_keys({"centre", "radius"});
  Sphere sphere{at.member("centre").point(), at.member("radius").number()};
  at_place(at, [&] { check_sphere(sphere, "the sphere"); });
  return sphere;
}

Ray read_ray(const JsonCursor& at) {
  at.require_keys({"origin", "direction", "max_distance"});
  Ray ray{.origin = at.member("origin").point(), .direction = at.member("direction").point()};
  if (at.has("max_distance")) ray.max_distance = at.member("max_distance").number();
  at_place(at, [&] { check_ray(ray, "the ray"); });
  return ray;
}

Pose pose_of(const JsonCursor& at) {
  return at.has("pose") ? read_pose(at.member("pose")) : Pose(Pose::Identity());
}

std::optional<RigidCourse> course_of(const JsonCursor& at) {
  if (!at.has("motion")) return std::nullopt;
  return read_course(at.member("motion"));
}

CaseBody read_body(const JsonCursor& at) {
  const JsonCursor body = at.member("body");
  body.require_keys({"sphere", "box", "capsule", "cylinder", "cone", "ellipsoid", "convex_hull",
                     "half_space", "plane", "mesh"});
  const Shape shape =
      read_body_shape(body, {.length = [](const JsonCursor& length) { return length.number(); },
                             .mesh = read_inline_mesh});
  const Pose pose = pose_of(at);
  at_place(at.has("pose") ? at.member("pose") : at, [&] { return bounding_aabb({shape, pose}); });
  CaseBody placed(shape, pose);
  placed.course = course_of(at);
  return placed;
}

CaseMeshFile read_mesh_file(const JsonCursor& at) {
  at.require_keys({"file", "sha256"});
  const JsonCursor hash = at.member("sha256");
  const bool is_hash = hash.text().size() == 64 &&
                       hash.text().find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!is_hash) hash.fail("is not a SHA-256 of 64 digits 0-9 a-f");
  return {at.member("file").text(), hash.text()};
}

class ShapeReader {
 public:
  ShapeReader(const JsonCursor& root, bool has_b, const ReadCaseSettings& settings)
      : root_(root), has_b_(has_b), settings_(settings) {}

  CaseShape read(std::string_view side) const {
    const JsonCursor at = root_.member(side);
    at.require_keys(
        {"triangle", "box", "obb", "sphere", "point", "mesh", "body", "ray", "pose", "motion"});
    const int kinds = at.has("triangle") + at.has("box") + at.has("obb") + at.has("sphere") +
                      at.has("point") + at.has("mesh") + at.has("body") + at.has("ray");
    if (kinds != 1) {
      at.fail("has " + std::to_string(kinds) +
              " shapes, not one of triangle, box, obb, sphere, point, mesh, body and ray");
    }
    if (at.has("pose") && !at.has("mesh") && !at.has("body")) {
      at.member("pose").fail("only a mesh and a body have a pose");
    }
    if (at.has("motion") && !at.has("mesh") && !at.has("body")) {
      at.member("motion").fail("only a mesh and a body move");
    }
    if (at.has("triangle")) return read_triangle(at.member("triangle"));
    if (at.has("box")) return read_box(at.member("box"));
    if (at.has("obb")) return read_obb(at.member("obb"));
    if (at.has("sphere")) return read_sphere(at.member("sphere"));
    if (at.has("point")) return CasePoint{at.member("point").point()};
    if (at.has("ray")) return read_ray(at.member("ray"));
    if (at.has("body")) return read_body(at);
    return read_placed_mesh(at, side);
  }

 private:
  CaseMesh read_placed_mesh(const JsonCursor& at, std::string_view side) const {
    const Pose pose = pose_of(at);
    const CaseMesh unplaced = read_mesh(at.member("mesh"), side, false);
    CaseMesh mesh(unplaced.mesh, pose);
    mesh.file = unplaced.file;
    mesh.course = course_of(at);
    const JsonCursor place = at.has("pose") ? at.member("pose") : at;
    at_place(place, [&] { check_placement(pose, mesh.mesh.bounds(), "the pose"); });
    return mesh;
  }

  /// Reads a mesh; with `is_referred` the other side has said that its mesh is this one.
  CaseMesh read_mesh(const JsonCursor& at, std::string_view side, bool is_referred) const {
    const Pose here = Pose::Identity();
    if (at.has("same_as")) {
      at.require_keys({"same_as"});
      const JsonCursor reference = at.member("same_as");
      const std::string& other = reference.text();
      if (other != "a" && other != "b") reference.fail("is neither \"a\" nor \"b\"");
      if (other == side || is_referred)
        reference.fail("the meshes refer to each other in a circle");
      if (other == "b" && !has_b_) reference.fail("there is no shape b");
      const JsonCursor owner = root_.member(other);
      if (!owner.has("mesh")) reference.fail("shape " + other + " is no mesh");
      return read_mesh(owner.member("mesh"), other, true);
    }
    if (at.has("file")) {
      const CaseMeshFile file = read_mesh_file(at);
      CaseMesh mesh(at_place(at, [&] { return load(file); }), here);
      mesh.file = file;
      return mesh;
    }
    return {read_inline_mesh(at), here};
  }

  Mesh load(const CaseMeshFile& file) const {
    return settings_.meshes ? settings_.meshes->load(file, settings_.mesh_folder)
                            : load_case_mesh(file, settings_.mesh_folder);
  }

  const JsonCursor& root_;
  bool has_b_;
  const ReadCaseSettings& settings_;
};

bool refers(const JsonCursor& root, std::string_view side) {
  const JsonCursor at = root.member(side);
  if (!at.has("mesh")) return false;
  return at.member("mesh").has("same_as");
}

}  // namespace

Mesh read_inline_mesh(const JsonCursor& at) {
  at.require_keys({"vertices", "triangles"});
  const JsonCursor vertex_list = at.member("vertices");
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(vertex_list.size());
  for (std::size_t i = 0; i < vertex_list.size(); ++i)
    vertices.push_back(vertex_list.item(i).point());
  const JsonCursor triangle_list = at.member("triangles");
  std::vector<TriangleIndices> triangles;
  triangles.reserve(triangle_list.size());
  for (std::size_t i = 0; i < triangle_list.size(); ++i) {
    const JsonCursor triangle = triangle_list.item(i);
    triangle.require_size(3);
    TriangleIndices indices{};
    for (std::size_t k = 0; k < 3; ++k) {
      const JsonCursor index = triangle.item(k);
      indices[k] = index.index(std::numeric_limits<std::uint32_t>::max());
      if (indices[k] >= vertices.size()) {
        index.fail("there is no vertex " + std::to_string(indices[k]) + "; the mesh has " +
                   std::to_string(vertices.size()));
      }
    }
    triangles.push_back(indices);
  }
  return at_place(at, [&] { return Mesh(vertices, triangles); });
}

Pose read_pose(const JsonCursor& at) {
  at.require_size(12);
  Pose pose = Pose::Identity();
  for (int i = 0; i < 12; ++i)
    pose.matrix()(i / 4, i % 4) = at.item(static_cast<std::size_t>(i)).number();
  at_place(at, [&] { return check_rigid(pose, "the pose"); });
  return pose;
}

CaseShapes read_shapes(const JsonCursor& root, bool has_b, const ReadCaseSettings& settings) {
  const ShapeReader reader(root, has_b, settings);
  CaseShapes shapes{reader.read("a"), std::nullopt};
  if (!has_b) return shapes;
  shapes.b = reader.read("b");
  // One mesh is one handle, so that its tree is shared, too.
  if (refers(root, "b")) std::get<CaseMesh>(*shapes.b).mesh = std::get<CaseMesh>(shapes.a).mesh;
  if (refers(root, "a")) std::get<CaseMesh>(shapes.a).mesh = std::get<CaseMesh>(*shapes.b).mesh;
  return shapes;
}

}  // namespace graze::cases
