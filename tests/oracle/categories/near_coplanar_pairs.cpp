#include <tests/oracle/category.h>

// Two triangles in nearly one plane: the signs of all orientations are at stake.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

struct Plane {
  Vector3d origin;
  Vector3d u;
  Vector3d v;

  explicit Plane(Sampler& s) : origin(s.point()), u(s.point()), v(s.point()) {}

  Vector3d point(Sampler& s) const {
    const double x = s.symmetric();
    const double y = s.symmetric();
    return origin + x * u + y * v;
  }

  Triangle triangle(Sampler& s) const {
    const Vector3d a = point(s);
    const Vector3d b = point(s);
    const Vector3d c = point(s);
    return {a, b, c};
  }
};

// The vertices are off the plane by the rounding of their coordinates.
TrianglePair by_rounding(Sampler& s) {
  const Plane plane(s);
  return {plane.triangle(s), plane.triangle(s)};
}

TrianglePair by_ulps(Sampler& s) {
  const Plane plane(s);
  return {s.nudged(plane.triangle(s), 4), s.nudged(plane.triangle(s), 4)};
}

TrianglePair axis_plane_by_ulps(Sampler& s) {
  const double height = s.symmetric();
  const auto flat = [&](const Vector3d& p) { return Vector3d(p.x(), p.y(), s.nudged(height, 2)); };
  const Triangle a = for_each_vertex(s.triangle(), flat);
  const Triangle b = for_each_vertex(s.triangle(), flat);
  return turned(s, TrianglePair{a, b});
}

// Each vertex off the plane by 1e-16 to 1e-3, the same order of magnitude within a pair.
TrianglePair by_a_little(Sampler& s) {
  const Plane plane(s);
  const Vector3d normal = plane.u.cross(plane.v);
  const double height = s.magnitude(-53, -10);
  const auto lifted = [&](const Vector3d& p) {
    return Vector3d(p + height * s.symmetric() * normal);
  };
  const Triangle a = for_each_vertex(plane.triangle(s), lifted);
  return {a, for_each_vertex(plane.triangle(s), lifted)};
}

// Parallel planes: B is A's plane moved along the normal, or tilted about a line through A.
TrianglePair hinged(Sampler& s) {
  const Plane plane(s);
  const Vector3d normal = plane.u.cross(plane.v);
  const double slope = s.magnitude(-53, -3);
  const double middle = s.symmetric();
  const auto tilted = [&] {
    const double x = s.symmetric();
    const double y = s.symmetric();
    return Vector3d(plane.origin + x * plane.u + y * plane.v + slope * (x - middle) * normal);
  };
  const Triangle a = plane.triangle(s);
  const Vector3d b = tilted();
  const Vector3d c = tilted();
  return {a, {b, c, tilted()}};
}

}  // namespace

void add_near_coplanar_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"near_coplanar_by_rounding", by_rounding});
  categories.push_back({"near_coplanar_by_ulps", by_ulps});
  categories.push_back({"near_coplanar_axis_plane", axis_plane_by_ulps});
  categories.push_back({"near_coplanar_by_a_little", by_a_little});
  categories.push_back({"near_coplanar_hinged", hinged});
}

}  // namespace graze::oracle
