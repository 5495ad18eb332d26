#include <graze/engine/cases/case_error.h>
#include <graze/engine/cases/case_words.h>
#include <graze/engine/cases/json_text.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/mesh/io/output_file.h>
#include <graze/engine/mesh/mesh_error.h>

#include <string_view>
#include <vector>

namespace graze {
namespace {

using cases::json_number;
using cases::json_point;
using cases::json_pose;
using cases::json_string;

/// `[item,item,...]`.
template <typename List, typename Write>
std::string list_of(const List& list, std::string_view separator, Write&& write) {
  std::string out = "[";
  bool is_first = true;
  for (const auto& item : list) {
    if (!is_first) out += separator;
    is_first = false;
    out += write(item);
  }
  return out + "]";
}

std::string text_of(const TrianglePair& pair) {
  return std::string("[") + std::to_string(pair.a) + "," + std::to_string(pair.b) + "]";
}

std::string text_of(const TriangleIndices& t) {
  return std::string("[") + std::to_string(t[0]) + "," + std::to_string(t[1]) + "," +
         std::to_string(t[2]) + "]";
}

/// How the numbers of an answer are written.
struct NumberText {
  std::string (*number)(double);

  std::string point(const Eigen::Vector3d& p) const {
    return std::string("[") + number(p.x()) + "," + number(p.y()) + "," + number(p.z()) + "]";
  }
  std::string contact(const CaseContact& contact) const {
    return std::string("{\"point\":") + point(contact.point) +
           ",\"point_a\":" + point(contact.point_a) + ",\"point_b\":" + point(contact.point_b) +
           ",\"normal\":" + point(contact.normal) + ",\"depth\":" + number(contact.depth) + "}";
  }
};

std::string mesh_text(const CaseMesh& mesh) {
  if (mesh.file) {
    return std::string("{\"file\": ") + json_string(mesh.file->path) +
           ", \"sha256\": " + json_string(mesh.file->sha256) + "}";
  }
  return std::string("{\"vertices\": ") + list_of(mesh.mesh.vertices(), ",\n      ", json_point) +
         ",\n    \"triangles\": " +
         list_of(mesh.mesh.triangles(), ",", [](const TriangleIndices& t) { return text_of(t); }) +
         "}";
}

/// The shape of a body, as a member named by its kind.
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
           list_of(points, ",\n      ", json_point) + "}";
  }
  std::string operator()(const HalfSpace& half_space) const {
    return std::string("\"half_space\": {\"normal\": ") + json_point(half_space.normal) +
           ", \"offset\": " + json_number(half_space.offset) + "}";
  }
  std::string operator()(const Mesh& mesh) const {
    return std::string("\"mesh\": ") + mesh_text(CaseMesh(mesh, Pose::Identity()));
  }
};

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
  std::string operator()(const CaseMesh& mesh) const {
    return std::string("{\"mesh\": ") + (is_same_as_a ? "{\"same_as\": \"a\"}" : mesh_text(mesh)) +
           ",\n    \"pose\": " + json_pose(mesh.pose) + "}";
  }
  std::string operator()(const CaseBody& body) const {
    return std::string("{\"body\": {") + std::visit(BodyText{}, body.shape.value()) +
           "},\n    \"pose\": " + json_pose(body.pose) + "}";
  }
};

std::string settings_text(const CaseSettings& settings, Ask ask) {
  std::string out;
  const auto add = [&](const std::string& member) { out += (out.empty() ? "" : ", ") + member; };
  if (settings.touch == Touch::Exclude) add("\"touch\": \"exclude\"");
  if (settings.interior == Interior::Solid) add("\"interior\": \"solid\"");
  if (ask == Ask::Within) add(std::string("\"clearance\": ") + json_number(settings.clearance));
  return out.empty() ? "" : ",\n  \"settings\": {" + out + "}";
}

bool is_one_mesh(const Case& query) {
  const auto* a = std::get_if<CaseMesh>(&query.a);
  const auto* b = query.b ? std::get_if<CaseMesh>(&*query.b) : nullptr;
  return a != nullptr && b != nullptr && a->mesh == b->mesh;
}

std::string answer_text(const CaseAnswer& answer, const NumberText& numbers) {
  std::string out;
  const auto add = [&](const char* key, const std::string& value) {
    out += (out.empty() ? "\"" : ",\"") + std::string(key) + "\":" + value;
  };
  const auto pair_text = [](const TrianglePair& pair) { return text_of(pair); };
  if (answer.says) add("says", *answer.says ? "true" : "false");
  if (answer.pairs) add("pairs", list_of(*answer.pairs, ",", pair_text));
  if (answer.triangles) {
    add("triangles",
        list_of(*answer.triangles, ",", [](std::uint32_t t) { return std::to_string(t); }));
  }
  if (answer.distance) add("distance", numbers.number(*answer.distance));
  if (answer.point_a) add("point_a", numbers.point(*answer.point_a));
  if (answer.point_b) add("point_b", numbers.point(*answer.point_b));
  if (answer.pair) add("pair", text_of(*answer.pair));
  if (answer.translation) add("translation", numbers.point(*answer.translation));
  if (answer.contacts) {
    add("contacts", list_of(*answer.contacts, ",",
                            [&](const CaseContact& contact) { return numbers.contact(contact); }));
  }
  return "{" + out + "}";
}

}  // namespace

std::string to_json(const CaseAnswer& answer) {
  return answer_text(answer, {json_number});
}

std::string to_plain_json(const CaseAnswer& answer) {
  return answer_text(answer, {cases::json_plain_number});
}

std::string to_json(const Case& query) {
  std::string out = "{\n  \"graze_case\": " + std::to_string(cases::kCaseVersion);
  if (!query.note.empty()) out += std::string(",\n  \"note\": ") + json_string(query.note);
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
}

void write_case(const std::filesystem::path& path, const Case& query) {
  try {
    mesh_io::OutputFile file(path);
    file.append(to_json(query));
    file.finish();
  } catch (const MeshError& error) {
    throw CaseError(error.what());
  }
}

}  // namespace graze
