#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/files/file_error.h>
#include <graze/engine/files/output_file.h>

#include <cmath>
#include <vector>

namespace graze {
namespace {

using cases::json_list;
using cases::json_number;
using cases::json_point;
using cases::json_pose;
using cases::json_string;

std::string text_of(const TriangleIndices& t) {
  return std::string("[") + std::to_string(t[0]) + "," + std::to_string(t[1]) + "," +
         std::to_string(t[2]) + "]";
}

std::string mesh_text(const CaseMesh& mesh) {
  if (mesh.file) {
    return std::string("{\"file\": ") + json_string(mesh.file->path) +
           ", \"sha256\": " + json_string(mesh.file->sha256) + "}";
  }
  return std::string("{\"vertices\": ") + json_list(mesh.mesh.vertices(), ",\n      ", json_point) +
         ",\n    \"triangles\": " +
         json_list(mesh.mesh.triangles(), ",",
                   [](const TriangleIndices& t) { return text_of(t); }) +
         "}";
}

/// Writes the shape of a body, as a member named by its kind.
struct BodyText {
  static std::string round(const char* kind, double radius, const char* name, double half) {
    return std::string("\"") + kind + "\": {\"radius\": " + json_number(radius) + ", \"" + name +
           "\": " + json_number(half) + "}";
  }

  std::string operator()(const Sphere& sphere) const {
    return std::string("\"sphere\": {\"centre\": ") + json_point(sphere.centre) +
           ", \"radius\": " + json_number(sphere.radius) + "}";
  }
  std::string operator()(const Box& box) const {
    return std::string("\"box\": {\"half_extents\": ") + json_point(box.half_extents) + "}";
  }
  std::string operator()(const Capsule& capsule) const {
    return round("capsule", capsule.radius, "half_length", capsule.half_length);
  }
  std::string operator()(const Cylinder& cylinder) const {
    return round("cylinder", cylinder.radius, "half_height", cylinder.half_height);
  }
  std::string operator()(const Cone& cone) const {
    return round("cone", cone.radius, "half_height", cone.half_height);
  }
  std::string operator()(const Ellipsoid& ellipsoid) const {
    return std::string("\"ellipsoid\": {\"centre\": ") + json_point(ellipsoid.centre) +
           ", \"semi_axes\": " + json_point(ellipsoid.semi_axes) + "}";
  }
  std::string operator()(const ConvexHull& hull) const {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < hull.vertex_count(); ++i)
      points.push_back(hull.vertex(i));
    return std::string("\"convex_hull\": {\"points\": ") +
           json_list(points, ",\n      ", json_point) + "}";
  }
  std::string operator()(const HalfSpace& s) const { return flat("half_space", s); }
  std::string operator()(const Plane& s) const { return flat("plane", s); }
  /// Writes a height field as the mesh that it is.
  std::string operator()(const HeightField& field) const { return (*this)(field.mesh()); }
  std::string operator()(const Mesh& mesh) const {
    return std::string("\"mesh\": ") + mesh_text(CaseMesh(mesh, Pose::Identity()));
  }

 private:
  template <typename Flat>
  static std::string flat(const char* kind, const Flat& s) {
    return std::string("\"") + kind + "\": {\"normal\": " + json_point(s.normal) +
           ", \"offset\": " + json_number(s.offset) + "}";
  }
};

std::string course_text(const std::optional<RigidCourse>& course) {
  if (!course) return "";
  return std::string(",\n    \"motion\": {\"centre\": ") + json_point(course->centre) +
         ", \"shift\": " + json_point(course->shift) +
         ",\n      \"axis\": " + json_point(course->axis) +
         ", \"angle\": " + json_number(course->angle) + "}";
}

struct ShapeText {
  bool is_same_as_a = false;

  std::string operator()(const Triangle& t) const {
    return std::string("{\"triangle\": [") + json_point(t.a) + ",\n      " + json_point(t.b) +
           ",\n      " + json_point(t.c) + "]}";
  }
  std::string operator()(const Aabb& box) const {
    return std::string("{\"box\": {\"min\": ") + json_point(box.min) +
           ", \"max\": " + json_point(box.max) + "}}";
  }
  std::string operator()(const Obb& box) const {
    return std::string("{\"obb\": {\"pose\": ") + json_pose(box.pose) +
           ", \"half_extents\": " + json_point(box.half_extents) + "}}";
  }
  std::string operator()(const Sphere& sphere) const {
    return std::string("{\"sphere\": {\"centre\": ") + json_point(sphere.centre) +
           ", \"radius\": " + json_number(sphere.radius) + "}}";
  }
  std::string operator()(const CasePoint& point) const {
    return std::string("{\"point\": ") + json_point(point.position) + "}";
  }
  std::string operator()(const Ray& ray) const {
    std::string out = std::string("{\"ray\": {\"origin\": ") + json_point(ray.origin) +
                      ", \"direction\": " + json_point(ray.direction);
    if (std::isfinite(ray.max_distance)) {
      out += std::string(", \"max_distance\": ") + json_number(ray.max_distance);
    }
    return out + "}}";
  }
  std::string operator()(const CaseMesh& mesh) const {
    return std::string("{\"mesh\": ") + (is_same_as_a ? "{\"same_as\": \"a\"}" : mesh_text(mesh)) +
           ",\n    \"pose\": " + json_pose(mesh.pose) + course_text(mesh.course) + "}";
  }
  std::string operator()(const CaseBody& body) const {
    return std::string("{\"body\": {") + std::visit(BodyText{}, body.shape.value()) +
           "},\n    \"pose\": " + json_pose(body.pose) + course_text(body.course) + "}";
  }
};

std::string settings_text(const CaseSettings& settings, Ask ask) {
  std::string out;
  const auto add = [&](const std::string& member) { out += (out.empty() ? "" : ", ") + member; };
  if (settings.hit == Hit::Crossing) add("\"touch\": \"exclude\"");
  if (settings.hit == Hit::Solid) add("\"interior\": \"solid\"");
  const bool is_of_motion = cases::is_about_motion(ask);
  if (ask == Ask::Within || is_of_motion)
    add(std::string("\"clearance\": ") + json_number(settings.clearance));
  if (is_of_motion) add(std::string("\"tolerance\": ") + json_number(settings.tolerance));
  if (settings.direction) add(std::string("\"direction\": ") + json_point(*settings.direction));
  if (settings.self_kind == SelfPairKind::Neighbour) add("\"kind\": \"neighbour\"");
  if (settings.limit) add(std::string("\"limit\": ") + std::to_string(*settings.limit));
  return out.empty() ? "" : ",\n  \"settings\": {" + out + "}";
}

bool is_one_mesh(const Case& query) {
  const auto* a = std::get_if<CaseMesh>(&query.a);
  const auto* b = query.b ? std::get_if<CaseMesh>(&*query.b) : nullptr;
  return a != nullptr && b != nullptr && a->mesh == b->mesh;
}

}  // namespace

std::string to_json(const Case& query) {
  return bvh::in_standard_arithmetic([&]() -> std::string {
    std::string out = "{\n  \"graze_case\": " + std::to_string(cases::kCaseVersion);
    if (!query.note.empty()) out += std::string(",\n  \"note\": ") + json_string(query.note);
    if (!query.origin.empty()) out += std::string(",\n  \"origin\": ") + json_string(query.origin);
    out += std::string(",\n  \"question\": ") + json_string(name_of(query.ask));
    out += settings_text(query.settings, query.ask);
    out += std::string(",\n  \"a\": ") + std::visit(ShapeText{}, query.a);
    if (query.b)
      out += std::string(",\n  \"b\": ") + std::visit(ShapeText{is_one_mesh(query)}, *query.b);
    if (query.answer) {
      out += std::string(",\n  \"answer\": ") + to_json(*query.answer);
      out += std::string(",\n  \"answered_by\": {\"engine\": ") +
             json_string(query.answered_by.engine) +
             ", \"version\": " + json_string(query.answered_by.version) + "}";
    }
    return out + "\n}\n";
  });
}

void write_case(const std::filesystem::path& path, const Case& query) {
  try {
    files::write_file(path, to_json(query));
  } catch (const files::FileError& error) {
    throw CaseError(error.what(), error.place());
  }
}

}  // namespace graze
