#include <graze/engine/cli/outlines/case_outlines.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace graze::cli {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr const char* kColourOfA = "#1f6fb4";
constexpr const char* kColourOfB = "#d95f02";
constexpr int kTurns = 48;  // the number of corners of a circle

/// Adds a circle around z.
void add_circle(Points& points, double radius, double z) {
  for (int i = 0; i < kTurns; ++i) {
    const double angle = 2 * std::numbers::pi * i / kTurns;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

Points unit_ball() {
  Points points = {{0, 0, 1}, {0, 0, -1}};
  constexpr int kHalf = kTurns / 2;
  for (int i = 1; i < kHalf; ++i) {
    const double angle = std::numbers::pi * i / kHalf;
    add_circle(points, std::sin(angle), std::cos(angle));
  }
  return points;
}

Points box_corners(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  Points points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back((i & 1) != 0 ? max.x() : min.x(), (i & 2) != 0 ? max.y() : min.y(),
                        (i & 4) != 0 ? max.z() : min.z());
  }
  return points;
}

Points ball_points(const Eigen::Vector3d& centre, const Eigen::Vector3d& semi_axes) {
  Points points = unit_ball();
  for (Eigen::Vector3d& point : points)
    point = point.cwiseProduct(semi_axes) + centre;
  return points;
}

/// Returns points on the surface of a convex shape, in its own frame.
struct SurfacePoints {
  Points operator()(const Sphere& s) const {
    return ball_points(s.centre, Eigen::Vector3d::Constant(s.radius));
  }
  Points operator()(const Box& s) const { return box_corners(-s.half_extents, s.half_extents); }
  Points operator()(const Capsule& s) const {
    const Eigen::Vector3d end(0, 0, s.half_length);
    Points points = ball_points(end, Eigen::Vector3d::Constant(s.radius));
    const Points others = ball_points(-end, Eigen::Vector3d::Constant(s.radius));
    points.insert(points.end(), others.begin(), others.end());
    return points;
  }
  Points operator()(const Cylinder& s) const {
    Points points;
    add_circle(points, s.radius, s.half_height);
    add_circle(points, s.radius, -s.half_height);
    return points;
  }
  Points operator()(const Cone& s) const {
    Points points = {{0, 0, s.half_height}};
    add_circle(points, s.radius, -s.half_height);
    return points;
  }
  Points operator()(const Ellipsoid& s) const { return ball_points(s.centre, s.semi_axes); }
  Points operator()(const ConvexHull& s) const {
    Points points;
    for (std::size_t i = 0; i < s.vertex_count(); ++i)
      points.push_back(s.vertex(i));
    return points;
  }
  Points operator()(const HalfSpace&) const { return {}; }    // see plane_near()
  Points operator()(const Plane&) const { return {}; }        // see plane_near()
  Points operator()(const Mesh&) const { return {}; }         // see add_triangles()
  Points operator()(const HeightField&) const { return {}; }  // a case has its mesh
};

void add_triangles(std::vector<Outline>& outlines, const Mesh& mesh, const Pose& pose) {
  for (std::size_t i = 0; i < std::min(mesh.triangles().size(), kMostTrianglesDrawn); ++i) {
    const Triangle t = place(pose, mesh.triangle(i));
    outlines.push_back({.points = {t.a, t.b, t.c}});
  }
}

struct ShapeOutlines {
  std::vector<Outline> operator()(const Triangle& t) const { return {{.points = {t.a, t.b, t.c}}}; }
  std::vector<Outline> operator()(const Aabb& box) const {
    return {{.points = box_corners(box.min, box.max), .is_silhouette = true}};
  }
  std::vector<Outline> operator()(const Obb& box) const {
    return placed(box_corners(-box.half_extents, box.half_extents), box.pose);
  }
  std::vector<Outline> operator()(const Sphere& sphere) const {
    return {{.points = SurfacePoints{}(sphere), .is_silhouette = true}};
  }
  std::vector<Outline> operator()(const CasePoint& point) const {
    return {{.points = {point.position}}};
  }
  std::vector<Outline> operator()(const Ray& ray) const {
    return {{.points = {ray.origin}}};  // its line: see add_line()
  }
  std::vector<Outline> operator()(const CaseMesh& mesh) const {
    std::vector<Outline> outlines;
    add_triangles(outlines, mesh.mesh, mesh.pose);
    return outlines;
  }
  std::vector<Outline> operator()(const CaseBody& body) const {
    std::vector<Outline> outlines;
    if (const Mesh* mesh = body.shape.as<Mesh>()) {
      add_triangles(outlines, *mesh, body.pose);
      return outlines;
    }
    if (compare::flat_of(body.shape)) return outlines;
    return placed(std::visit(SurfacePoints{}, body.shape.value()), body.pose);
  }

 private:
  static std::vector<Outline> placed(Points points, const Pose& pose) {
    for (Eigen::Vector3d& point : points)
      point = place(pose, point);
    return {{.points = std::move(points), .is_silhouette = true}};
  }
};

/// Returns a square of the plane, as large as what it is near to.
Outline plane_near(const CaseBody& body, const std::vector<Outline>& other) {
  Eigen::Vector3d min = body.pose.translation();
  Eigen::Vector3d max = min;
  if (!other.empty()) min = max = other.front().points.front();
  for (const Outline& outline : other) {
    for (const Eigen::Vector3d& point : outline.points) {
      min = min.cwiseMin(point);
      max = max.cwiseMax(point);
    }
  }
  const HalfSpace plane = *compare::flat_of(body.shape);
  const Eigen::Vector3d normal = body.pose.linear() * plane.normal;
  const Eigen::Vector3d origin = place(body.pose, plane.normal * plane.offset);
  const Eigen::Vector3d middle = (min + max) / 2;
  const Eigen::Vector3d centre = middle - normal * normal.dot(middle - origin);
  const double size = other.empty() ? 1 : (max - min).maxCoeff();
  const Eigen::Vector3d right = normal.unitOrthogonal() * size;
  const Eigen::Vector3d up = normal.cross(right);
  return {.points = {centre - right - up, centre + right - up, centre + right + up,
                     centre - right + up}};
}

/// Adds the ray from its origin to where it leaves behind what it is cast at.
void add_line(std::vector<Outline>& outlines, const Ray& ray, const std::vector<Outline>& other) {
  const Eigen::Vector3d unit = ray.direction.stableNormalized();
  double length = 0;
  for (const Outline& outline : other) {
    for (const Eigen::Vector3d& point : outline.points)
      length = std::max(length, (point - ray.origin).norm());
  }
  outlines.front().points.push_back(ray.origin + std::min(length, ray.max_distance) * unit);
}

void add_plane(std::vector<Outline>& outlines, const CaseShape& shape,
               const std::vector<Outline>& other) {
  const auto* body = std::get_if<CaseBody>(&shape);
  if (body == nullptr || !compare::flat_of(body->shape)) return;
  outlines.push_back(plane_near(*body, other));
}

}  // namespace

std::vector<Outline> case_outlines(const Case& query) {
  std::vector<Outline> a = std::visit(ShapeOutlines{}, query.a);
  std::vector<Outline> b;
  if (query.b) {
    b = std::visit(ShapeOutlines{}, *query.b);
    add_plane(b, *query.b, a);
    if (const auto* ray = std::get_if<Ray>(&*query.b)) add_line(b, *ray, a);
  }
  add_plane(a, query.a, b);
  for (Outline& outline : a)
    outline.colour = kColourOfA;
  for (Outline& outline : b)
    outline.colour = kColourOfB;
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace graze::cli
