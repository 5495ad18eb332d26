#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/compare/peers/process/protocol.h>
#include <graze/engine/compare/peers/process/shape_points.h>
#include <graze/engine/files/source.h>

#include <algorithm>
#include <limits>
#include <variant>

namespace graze::compare {
namespace {

using cases::json_list;
using cases::JsonCursor;

std::string number(double value) {
  return cases::json_plain_number(value);
}

std::string text_of(const Eigen::Vector3d& p) {
  return std::string("[") + number(p.x()) + "," + number(p.y()) + "," + number(p.z()) + "]";
}

std::string text_of(const TriangleIndices& t) {
  return std::string("[") + std::to_string(t[0]) + "," + std::to_string(t[1]) + "," +
         std::to_string(t[2]) + "]";
}

std::string text_of(const Pose& pose) {
  std::string out = "[";
  for (int i = 0; i < 12; ++i) {
    if (i > 0) out += ',';
    out += number(pose(i / 4, i % 4));
  }
  return out + "]";
}

std::string text_of(const RigidCourse& course) {
  return std::string("{\"centre\":") + text_of(course.centre) +
         ",\"shift\":" + text_of(course.shift) + ",\"axis\":" + text_of(course.axis) +
         ",\"angle\":" + number(course.angle) + "}";
}

std::string text_of(const Mesh& mesh) {
  const auto item = [](const auto& each) { return text_of(each); };
  return std::string("{\"vertices\":") + json_list(mesh.vertices(), ",", item) +
         ",\"triangles\":" + json_list(mesh.triangles(), ",", item) + "}";
}

/// Returns the lengths that the question has, if any.
std::string lengths_text(const Question& question) {
  const CaseSettings& settings = question.settings;
  const bool is_of_motion = cases::is_about_motion(question.ask);
  if (question.ask == Ask::Separation && settings.direction)
    return ",\"settings\":{\"direction\":" + text_of(*settings.direction) + "}";
  if (question.ask != Ask::Within && !is_of_motion) return "";
  return ",\"settings\":{\"clearance\":" + number(settings.clearance) +
         (is_of_motion ? ",\"tolerance\":" + number(settings.tolerance) : std::string()) + "}";
}

/// Returns the member of a shape, as a case has it.
struct ShapeText {
  static std::string round(const char* kind, double radius, const char* name, double half) {
    return std::string("{\"") + kind + "\":{\"radius\":" + number(radius) + ",\"" + name +
           "\":" + number(half) + "}}";
  }

  std::string operator()(const Sphere& s) const {
    return std::string("{\"sphere\":{\"centre\":") + text_of(s.centre) +
           ",\"radius\":" + number(s.radius) + "}}";
  }
  std::string operator()(const Box& s) const {
    return std::string("{\"box\":{\"half_extents\":") + text_of(s.half_extents) + "}}";
  }
  std::string operator()(const Capsule& s) const {
    return round("capsule", s.radius, "half_length", s.half_length);
  }
  std::string operator()(const Cylinder& s) const {
    return round("cylinder", s.radius, "half_height", s.half_height);
  }
  std::string operator()(const Cone& s) const {
    return round("cone", s.radius, "half_height", s.half_height);
  }
  std::string operator()(const Ellipsoid& s) const {
    return std::string("{\"ellipsoid\":{\"centre\":") + text_of(s.centre) +
           ",\"semi_axes\":" + text_of(s.semi_axes) + "}}";
  }
  std::string operator()(const ConvexHull& s) const {
    const std::optional<std::vector<Eigen::Vector3d>> points = points_of(s);
    if (!points) return "";
    return std::string("{\"convex_hull\":{\"points\":") +
           json_list(*points, ",", [](const Eigen::Vector3d& p) { return text_of(p); }) + "}}";
  }
  std::string operator()(const HalfSpace& s) const { return flat("half_space", s); }
  std::string operator()(const Plane& s) const {
    return flat("plane", HalfSpace{s.normal, s.offset});
  }
  std::string operator()(const HeightField& s) const { return (*this)(s.mesh()); }
  std::string operator()(const Mesh& s) const {
    return std::string("{\"mesh\":") + text_of(s) + "}";
  }

 private:
  static std::string flat(const char* kind, const HalfSpace& s) {
    const std::optional<HalfSpace> source = source_of(s);
    if (!source) return "";
    return std::string("{\"") + kind + "\":{\"normal\":" + text_of(source->normal) +
           ",\"offset\":" + number(source->offset) + "}}";
  }
};

}  // namespace

std::string load_text(const Mesh& mesh_a, const Mesh& mesh_b) {
  const std::string b = mesh_a == mesh_b ? std::string("{\"same_as\":\"a\"}") : text_of(mesh_b);
  return std::string("\"load\":{\"a\":") + text_of(mesh_a) + ",\"b\":" + b + "}";
}

std::string load_text(std::span<const std::string> shape_texts) {
  return std::string("\"load\":{\"shapes\":") +
         json_list(shape_texts, ",", [](const std::string& text) { return text; }) + "}";
}

std::string request_line(std::uint64_t id, std::string_view member) {
  std::string line = "{\"id\":" + std::to_string(id) + ",";
  line += member;
  return line + "}\n";
}

std::string question_text(const Question& question, const Pose& pose_a, const Pose& pose_b) {
  std::string out = std::string("\"question\":\"") + name_of(question.ask) + "\"";
  out += lengths_text(question);
  out += ",\"pose_a\":" + text_of(pose_a) + ",\"pose_b\":" + text_of(pose_b);
  if (question.course_a) out += ",\"motion_a\":" + text_of(*question.course_a);
  if (question.course_b) out += ",\"motion_b\":" + text_of(*question.course_b);
  return out;
}

std::string question_text(std::span<const PlacedShape> bodies, BodyPairs pairs) {
  const auto body = [](const PlacedShape& each) {
    return std::string("{\"shape\":") + std::to_string(each.shape) +
           ",\"pose\":" + text_of(each.pose) + "}";
  };
  const auto pair = [](const std::pair<std::size_t, std::size_t>& each) {
    return std::string("[") + std::to_string(each.first) + "," + std::to_string(each.second) + "]";
  };
  return std::string("\"question\":\"any\",\"bodies\":") + json_list(bodies, ",", body) +
         ",\"pairs\":" + json_list(pairs, ",", pair);
}

std::string question_text(const Question& question, const PlacedShape& a, const PlacedShape& b) {
  const auto body = [](const PlacedShape& each, const std::optional<RigidCourse>& course) {
    return std::string("{\"shape\":") + std::to_string(each.shape) +
           ",\"pose\":" + text_of(each.pose) +
           (course ? ",\"motion\":" + text_of(*course) : std::string()) + "}";
  };
  return std::string("\"question\":\"") + name_of(question.ask) + "\"" + lengths_text(question) +
         ",\"bodies\":[" + body(a, question.course_a) + "," + body(b, question.course_b) + "]";
}

std::optional<std::string> shape_text(const Shape& shape) {
  std::string text = std::visit(ShapeText{}, shape.value());
  return text.empty() ? std::nullopt : std::optional(std::move(text));
}

PeerHello read_hello(const JsonCursor& at) {
  const std::uint32_t version =
      at.member("graze_peer").index(std::numeric_limits<std::uint32_t>::max());
  if (version != kPeerProtocol) {
    at.member("graze_peer")
        .fail("is version " + std::to_string(version) + " of the protocol; this program speaks " +
              std::to_string(kPeerProtocol));
  }
  at.require_keys({"graze_peer", "engine", "version", "alone", "questions", "scenes", "tolerance"});
  PeerHello hello;
  hello.witness.engine = mesh_io::printable(at.member("engine").text());
  if (at.has("version")) hello.witness.version = mesh_io::printable(at.member("version").text());
  hello.can_fork = at.has("alone") && at.member("alone").boolean();
  hello.answers_scenes = at.has("scenes") && at.member("scenes").boolean();
  if (at.has("tolerance")) {
    hello.tolerance = at.member("tolerance").number();
    if (!(*hello.tolerance >= 0)) at.member("tolerance").fail("is below 0");
  }
  if (!at.has("questions")) return hello;
  const JsonCursor list = at.member("questions");
  hello.questions.emplace();
  for (std::size_t i = 0; i < list.size(); ++i)
    hello.questions->push_back(list.item(i).text());
  return hello;
}

bool PeerHello::may_know(Ask ask) const {
  return !questions ||
         std::find(questions->begin(), questions->end(), name_of(ask)) != questions->end();
}

Shape read_shape(const JsonCursor& at) {
  return cases::read_body_shape(at,
                                {.length = [](const JsonCursor& length) { return length.number(); },
                                 .mesh = cases::read_inline_mesh});
}

}  // namespace graze::compare
