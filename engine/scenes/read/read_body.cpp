#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/files/source.h>
#include <graze/engine/scenes/path/turn.h>
#include <graze/engine/scenes/read/scene_parts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace graze::scenes {
namespace {

using cases::at_place;
using cases::JsonCursor;

BodyKind read_motion(const JsonCursor& at) {
  constexpr std::array<std::pair<const char*, BodyKind>, 3> kMotions = {
      {{"static", BodyKind::Static},
       {"kinematic", BodyKind::Kinematic},
       {"dynamic", BodyKind::Dynamic}}};
  for (const auto& [name, motion] : kMotions)
    if (at.text() == name) return motion;
  at.fail(mesh_io::quoted(at.text()) + " is none of static, kinematic and dynamic");
}

Detection read_detection(const JsonCursor& at) {
  if (at.text() == "discrete") return Detection::Discrete;
  if (at.text() == "continuous") return Detection::Continuous;
  at.fail(mesh_io::quoted(at.text()) + " is none of discrete and continuous");
}

std::uint32_t read_bits(const JsonCursor& at) {
  return at.index(std::numeric_limits<std::uint32_t>::max());
}

Filter read_filter(const JsonCursor& at) {
  at.require_keys({"category", "mask", "group"});
  Filter filter;
  if (at.has("category")) filter.category = read_bits(at.member("category"));
  if (at.has("mask")) filter.mask = read_bits(at.member("mask"));
  if (at.has("group")) {
    filter.group = static_cast<std::int32_t>(at.member("group").whole(
        std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()));
  }
  return filter;
}

/// Reads the rows of [R | t].
Pose read_rows(const JsonCursor& at, const SceneUnits& units) {
  at.require_size(12);
  Pose pose = Pose::Identity();
  for (int i = 0; i < 12; ++i) {
    const JsonCursor number = at.item(static_cast<std::size_t>(i));
    pose.matrix()(i / 4, i % 4) = i % 4 == 3 ? units.read_length(number) : number.number();
  }
  return pose;
}

Pose read_pose(const JsonCursor& at, const SceneUnits& units, const BodyShape& shape) {
  Pose pose = Pose::Identity();
  if (at.is_object()) {
    at.require_keys({"position", "axis", "angle"});
    if (at.has("axis") != at.has("angle")) at.fail("an axis needs an angle, and an angle an axis");
    if (at.has("axis")) {
      const double turns = units.angle.to_turns(at.member("angle").number());
      pose.matrix().topLeftCorner<3, 3>() =
          matrix_of(turned_by(read_direction(at.member("axis")), turns));
    }
    if (at.has("position")) {
      const Eigen::Vector3d position = units.read_point(at.member("position"));
      for (int i = 0; i < 3; ++i)
        pose.matrix()(i, 3) = position.data()[i];
    }
  } else {
    pose = read_rows(at, units);
  }
  at_place(at, [&] { return shape.bounds(pose); });  // refuses what a world would refuse
  return pose;
}

std::vector<ScenePart> read_parts(const JsonCursor& at, const SceneUnits& units, const Scene& scene,
                                  const NameTable& shapes) {
  if (at.size() == 0) at.fail("has no parts");
  std::vector<ScenePart> parts;
  parts.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    const JsonCursor each = at.item(i);
    each.require_keys({"shape", "pose", "filter", "user_data", "material"});
    ScenePart part;
    part.shape = shapes.find(each.member("shape"));
    const Shape& shape = scene.shapes[part.shape].shape;
    if (each.has("pose")) part.pose = read_pose(each.member("pose"), units, *share(shape));
    if (each.has("filter")) part.settings.filter = read_filter(each.member("filter"));
    if (each.has("user_data")) part.settings.user_data = read_bits(each.member("user_data"));
    if (each.has("material")) part.settings.material = read_bits(each.member("material"));
    at_place(each, [&] { return Compound().add({shape, part.pose}); });
    parts.push_back(part);
  }
  return parts;
}

KeyPath read_keys(const JsonCursor& at, const SceneUnits& units, const BodyShape& shape) {
  if (at.size() == 0) at.fail("has no keys");
  KeyPath path;
  path.keys.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    const JsonCursor key = at.item(i);
    key.require_keys({"time", "pose"});
    const JsonCursor time = key.member("time");
    if (i > 0 && !(time.number() > path.keys.back().time))
      time.fail("is not after the key before it");
    path.keys.push_back({time.number(), read_pose(key.member("pose"), units, shape)});
  }
  return path;
}

SteadyPath read_steady(const JsonCursor& at, const SceneUnits& units) {
  SteadyPath path;
  if (at.has("axis") != at.has("rate")) at.fail("an axis needs a rate, and a rate an axis");
  if (!at.has("axis") && !at.has("velocity")) at.fail("has no keys, velocity or rate");
  if (at.has("velocity")) path.velocity = units.read_point(at.member("velocity"));
  if (at.has("axis")) {
    path.axis = read_direction(at.member("axis"));
    path.rate = units.angle.to_turns(at.member("rate").number());
  }
  return path;
}

BodyPath read_path(const JsonCursor& at, const SceneUnits& units, const BodyShape& shape) {
  at.require_keys({"keys", "velocity", "axis", "rate"});
  if (!at.has("keys")) return read_steady(at, units);
  if (at.has("velocity") || at.has("axis") || at.has("rate")) {
    at.fail("has keys and a velocity or rate; a path has one or the other");
  }
  return read_keys(at.member("keys"), units, shape);
}

}  // namespace

// It is divided by the largest first, so that squares neither overflow nor vanish.
Eigen::Vector3d read_direction(const JsonCursor& at) {
  const Eigen::Vector3d v = at.point();
  const double largest = std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
  if (!(largest > 0)) at.fail("is zero, and no direction");
  const double x = v.x() / largest, y = v.y() / largest, z = v.z() / largest;
  const double length = std::sqrt((x * x + y * y) + z * z);
  return {x / length, y / length, z / length};
}

std::string NameTable::add(const JsonCursor& at) {
  const std::string& name = at.text();
  if (name.empty()) at.fail("is empty");
  if (!indices_.emplace(name, indices_.size()).second) {
    at.fail(std::string("there is a ") + what_ + " " + mesh_io::quoted(name) + " already");
  }
  return name;
}

std::size_t NameTable::find(const JsonCursor& at) const {
  const auto found = indices_.find(at.text());
  if (found == indices_.end()) {
    at.fail(std::string("there is no ") + what_ + " " + mesh_io::quoted(at.text()));
  }
  return found->second;
}

SceneBody read_body(const JsonCursor& at, const SceneUnits& units, const Scene& scene,
                    const NameTable& shapes) {
  at.require_keys({"name", "shape", "parts", "pose", "motion", "detection", "filter", "path"});
  SceneBody body;
  body.name = at.member("name").text();
  if (at.has("parts")) {
    if (at.has("shape")) at.fail("has a shape and parts; a body has one or the other");
    body.parts = read_parts(at.member("parts"), units, scene, shapes);
  } else {
    body.shape = shapes.find(at.member("shape"));
  }
  const auto shape = at_place(at, [&] { return body_shape(scene, body); });
  body.pose = Pose::Identity();
  if (at.has("pose")) body.pose = read_pose(at.member("pose"), units, *shape);
  if (at.has("motion")) body.kind = read_motion(at.member("motion"));
  if (at.has("detection")) body.detection = read_detection(at.member("detection"));
  if (at.has("filter")) body.filter = read_filter(at.member("filter"));
  if (!at.has("path")) return body;
  const JsonCursor path = at.member("path");
  if (body.kind == BodyKind::Static) path.fail("a static body has no path");
  body.path = read_path(path, units, *shape);
  if (!std::holds_alternative<KeyPath>(body.path)) return body;
  if (at.has("pose")) at.member("pose").fail("a body with keys begins where they say");
  body.pose = pose_at(body, 0);
  return body;
}

}  // namespace graze::scenes
