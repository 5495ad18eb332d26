#include "tests/engine/special_poses/pair_text.h"

#include <graze/bvh/error.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <sstream>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze::tests {

using Eigen::Vector3d;

namespace {

using Numbers = std::vector<double>;

void add(Numbers& numbers, const Vector3d& v) {
  numbers.insert(numbers.end(), v.data(), v.data() + 3);
}

/// Of a box, by make_box(), a mesh is told by its half extents.
bool is_box(const Mesh& mesh) {
  return mesh.triangles().size() == 12;
}

std::string word_of(const Shape& shape) {
  const auto* mesh = shape.as<Mesh>();
  return mesh != nullptr && !is_box(*mesh) ? "triangles" : name_of(shape.kind());
}

Numbers numbers_of(const Shape& shape) {
  Numbers all;
  if (const auto* s = shape.as<Sphere>()) add(all, s->centre), all.push_back(s->radius);
  if (const auto* s = shape.as<Box>()) add(all, s->half_extents);
  if (const auto* s = shape.as<Capsule>()) all = {s->radius, s->half_length};
  if (const auto* s = shape.as<Cylinder>()) all = {s->radius, s->half_height};
  if (const auto* s = shape.as<Cone>()) all = {s->radius, s->half_height};
  if (const auto* s = shape.as<Ellipsoid>()) add(all, s->centre), add(all, s->semi_axes);
  if (const auto* s = shape.as<HalfSpace>()) add(all, s->normal), all.push_back(s->offset);
  if (const auto* s = shape.as<ConvexHull>()) {
    for (std::size_t i = 0; i < s->vertex_count(); ++i)
      add(all, s->vertex(i));
  }
  if (const auto* s = shape.as<Mesh>()) {
    if (is_box(*s)) {
      add(all, s->bounds().max);
    } else {
      for (const TriangleIndices& triangle : s->triangles()) {
        for (const std::uint32_t corner : triangle)
          add(all, s->vertices()[corner]);
      }
    }
  }
  return all;
}

std::string line_of(const std::string& word, const Numbers& numbers) {
  std::string line = word;
  for (const double number : numbers) {
    char shortest[32];
    const auto end = std::to_chars(std::begin(shortest), std::end(shortest), number).ptr;
    line += ' ';
    line.append(shortest, end);
  }
  return line + "\n";
}

std::string line_of(const Pose& pose) {
  Numbers rows;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j)
      rows.push_back(pose(i, j));
  }
  return line_of("at", rows);
}

struct Line {
  std::string word;
  Numbers numbers;
};

std::optional<Line> next_line(std::istream& text) {
  std::string line;
  while (std::getline(text, line)) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t end_of_name = line.find_first_of("-0123456789", line.find(' '));
    if (end_of_name == std::string::npos) throw InputError("pairs: no numbers: " + line);
    Line read{line.substr(0, end_of_name - 1), {}};
    std::istringstream words(line.substr(end_of_name));
    for (std::string word; words >> word;) {
      double number = 0;
      const char* end = word.data() + word.size();
      if (std::from_chars(word.data(), end, number).ptr != end) throw InputError("pairs: " + line);
      read.numbers.push_back(number);
    }
    return read;
  }
  return std::nullopt;
}

Shape shape_of(const Line& line) {
  const Numbers& n = line.numbers;
  const auto is = [&](ShapeKind kind, std::size_t count) {
    return line.word == name_of(kind) && n.size() == count;
  };
  const auto vector = [&](std::size_t from) { return Vector3d(n[from], n[from + 1], n[from + 2]); };
  if (is(ShapeKind::Sphere, 4)) return Sphere{vector(0), n[3]};
  if (is(ShapeKind::Box, 3)) return Box{vector(0)};
  if (is(ShapeKind::Capsule, 2)) return Capsule{n[0], n[1]};
  if (is(ShapeKind::Cylinder, 2)) return Cylinder{n[0], n[1]};
  if (is(ShapeKind::Cone, 2)) return Cone{n[0], n[1]};
  if (is(ShapeKind::Ellipsoid, 6)) return Ellipsoid{vector(0), vector(3)};
  if (is(ShapeKind::HalfSpace, 4)) return HalfSpace{vector(0), n[3]};
  if (is(ShapeKind::Mesh, 3)) return make_box(vector(0));
  if (line.word == "triangles" && n.size() % 9 == 0) {
    std::vector<Vector3d> corners;
    std::vector<TriangleIndices> triangles;
    for (std::size_t i = 0; i < n.size(); i += 3)
      corners.push_back(vector(i));
    for (std::uint32_t i = 0; i < corners.size(); i += 3)
      triangles.push_back({i, i + 1, i + 2});
    return Mesh(corners, triangles);
  }
  if (is(ShapeKind::ConvexHull, n.size()) && n.size() % 3 == 0) {
    std::vector<Vector3d> corners;
    for (std::size_t i = 0; i < n.size(); i += 3)
      corners.push_back(vector(i));
    return ConvexHull(corners);
  }
  throw InputError("pairs: no shape is a " + line.word + " of so many numbers");
}

Pose pose_of(const std::optional<Line>& line) {
  if (!line || line->word != "at" || line->numbers.size() != 12)
    throw InputError("pairs: no pose after a shape");
  Pose pose = Pose::Identity();
  for (int i = 0; i < 12; ++i)
    pose.matrix()(i / 4, i % 4) = line->numbers[static_cast<std::size_t>(i)];
  return pose;
}

}  // namespace

std::string text_of(const PlacedPair& pair) {
  return line_of(word_of(pair.a), numbers_of(pair.a)) + line_of(pair.pose_a) +
         line_of(word_of(pair.b), numbers_of(pair.b)) + line_of(pair.pose_b);
}

std::optional<PlacedPair> read_pair(std::istream& text) {
  const std::optional<Line> first = next_line(text);
  if (!first) return std::nullopt;
  const Pose pose_a = pose_of(next_line(text));
  const std::optional<Line> second = next_line(text);
  if (!second) throw InputError("pairs: the last has one shape");
  return PlacedPair{shape_of(*first), shape_of(*second), pose_a, pose_of(next_line(text))};
}

}  // namespace graze::tests
