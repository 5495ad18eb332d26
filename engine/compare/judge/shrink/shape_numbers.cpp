#include <graze/engine/compare/judge/shrink/shape_numbers.h>
#include <graze/engine/mesh/placement.h>

#include <cstdint>

namespace graze::compare {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points points_of(const ConvexHull& hull) {
  Points points;
  for (std::size_t i = 0; i < hull.vertex_count(); ++i)
    points.push_back(hull.vertex(i));
  return points;
}

Points points_of(const Mesh& mesh) {
  return {mesh.vertices().begin(), mesh.vertices().end()};
}

Points points_of(const HeightField& field) {
  return points_of(field.mesh());
}

Points points_in(std::span<const double> numbers) {
  Points points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return points;
}

struct Listed {
  std::vector<double> numbers = {};

  void add(const Eigen::Vector3d& point) {
    numbers.insert(numbers.end(), point.data(), point.data() + 3);
  }
  void operator()(const Sphere& s) {
    add(s.centre);
    numbers.push_back(s.radius);
  }
  void operator()(const Box& s) { add(s.half_extents); }
  void operator()(const Capsule& s) { numbers = {s.radius, s.half_length}; }
  void operator()(const Cylinder& s) { numbers = {s.radius, s.half_height}; }
  void operator()(const Cone& s) { numbers = {s.radius, s.half_height}; }
  void operator()(const Ellipsoid& s) {
    add(s.centre);
    add(s.semi_axes);
  }
  void operator()(const HalfSpace& s) {
    add(s.normal);
    numbers.push_back(s.offset);
  }
  void operator()(const Plane& s) { (*this)(HalfSpace{s.normal, s.offset}); }
  template <typename Corners>
  void operator()(const Corners& s) {
    for (const Eigen::Vector3d& point : points_of(s))
      add(point);
  }
};

struct Rebuilt {
  std::span<const double> n;

  Eigen::Vector3d point(std::size_t first) const { return {n[first], n[first + 1], n[first + 2]}; }

  Shape operator()(const Sphere&) const { return Sphere{point(0), n[3]}; }
  Shape operator()(const Box&) const { return Box{point(0)}; }
  Shape operator()(const Capsule&) const { return Capsule{n[0], n[1]}; }
  Shape operator()(const Cylinder&) const { return Cylinder{n[0], n[1]}; }
  Shape operator()(const Cone&) const { return Cone{n[0], n[1]}; }
  Shape operator()(const Ellipsoid&) const { return Ellipsoid{point(0), point(3)}; }
  Shape operator()(const HalfSpace&) const { return HalfSpace{point(0), n[3]}; }
  Shape operator()(const Plane&) const { return Plane{point(0), n[3]}; }
  Shape operator()(const ConvexHull&) const { return ConvexHull(points_in(n)); }
  Shape operator()(const Mesh& mesh) const { return Mesh(points_in(n), mesh.triangles()); }
  Shape operator()(const HeightField& field) const { return (*this)(field.mesh()); }
};

}  // namespace

std::vector<double> numbers_of(const Shape& shape) {
  Listed listed;
  std::visit(listed, shape.value());
  return listed.numbers;
}

Shape with_numbers(const Shape& shape, std::span<const double> numbers) {
  return std::visit(Rebuilt{numbers}, shape.value());
}

std::size_t part_count(const Shape& shape) {
  if (const Mesh* mesh = shape.as<Mesh>()) return mesh->triangles().size();
  if (const auto* hull = shape.as<ConvexHull>()) return hull->vertex_count();
  return 0;
}

Shape with_parts(const Shape& shape, const Indices& parts) {
  if (const Mesh* mesh = shape.as<Mesh>()) return part_of(*mesh, parts);
  const auto* hull = shape.as<ConvexHull>();
  if (hull == nullptr) return shape;
  Points points;
  for (const std::uint32_t i : parts)
    points.push_back(hull->vertex(i));
  return ConvexHull(points);
}

Mesh part_of(const Mesh& mesh, const Indices& triangles) {
  Points vertices;
  std::vector<TriangleIndices> indices;
  for (const std::uint32_t i : triangles) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    const Triangle t = mesh.triangle(i);
    vertices.insert(vertices.end(), {t.a, t.b, t.c});
    indices.push_back({first, first + 1, first + 2});
  }
  return {vertices, indices};
}

std::optional<Shape> unplaced(const Shape& shape, const Pose& pose) {
  if (const auto* ball = shape.as<Sphere>()) return Sphere{place(pose, ball->centre), ball->radius};
  if (part_count(shape) == 0) return std::nullopt;
  std::vector<double> numbers = numbers_of(shape);
  Listed placed;
  for (const Eigen::Vector3d& point : points_in(numbers))
    placed.add(place(pose, point));
  return with_numbers(shape, placed.numbers);
}

}  // namespace graze::compare
