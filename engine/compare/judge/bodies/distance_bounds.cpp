#include <graze/engine/compare/judge/bodies/distance_bounds.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/compare/judge/rational/in_metres.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace graze::compare {

using Eigen::Vector3d;

double proved_gap(const PlacedBody& a, const PlacedBody& b, Vector3d n) {
  // A half-space is bounded in its own direction only, and a plane in its two.
  const Vector3d proposed = n;
  const auto turned_to = [&](const PlacedBody& plane, const Vector3d& out) {
    const bool is_two_sided = plane.shape.kind() == ShapeKind::Plane;
    n = is_two_sided && out.dot(proposed) < 0 ? -out : out;
  };
  if (const auto plane = flat_of(a.shape)) turned_to(a, a.pose.linear() * plane->normal);
  if (const auto plane = flat_of(b.shape)) turned_to(b, -(b.pose.linear() * plane->normal));
  const double gap = -support_along(b.shape, b.pose, -n) - support_along(a.shape, a.pose, n);
  return std::isnan(gap) ? -std::numeric_limits<double>::infinity() : gap;
}

double best_proved_gap(const PlacedBody& a, const PlacedBody& b, const Vector3d& proposed) {
  double best = proved_gap(a, b, proposed);
  for (const PlacedBody* body : {&a, &b}) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d n = body->pose.linear().col(axis);
      best = std::max({best, proved_gap(a, b, n), proved_gap(a, b, -n)});
    }
  }
  return best;
}

double largest_of(const PlacedBody& body) {
  if (const auto plane = flat_of(body.shape))
    return body.pose.translation().cwiseAbs().maxCoeff() + std::abs(plane->offset);
  const Aabb box = bounding_aabb({body.shape, body.pose});
  return std::max({box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff(),
                   body.pose.translation().cwiseAbs().maxCoeff()});
}

std::optional<double> exact_distance(const PlacedBody& a, const PlacedBody& b) {
  const auto* ball_a = a.shape.as<Sphere>();
  const auto* ball_b = b.shape.as<Sphere>();
  const Mesh* mesh_a = a.shape.as<Mesh>();
  const Mesh* mesh_b = b.shape.as<Mesh>();
  const auto centre_of = [](const PlacedBody& body, const Sphere& ball) {
    const Vector3d p = place(body.pose, ball.centre);
    return exactly(Triangle{p, p, p});
  };
  std::optional<mpq_class> square;
  double radii = 0;
  if (mesh_a != nullptr && mesh_b != nullptr) {
    square = MeshReferee({*mesh_a, a.pose}, {*mesh_b, b.pose}).find_gap().square;
  } else if (ball_a != nullptr && ball_b != nullptr) {
    square = squared_distance(centre_of(a, *ball_a), centre_of(b, *ball_b));
    radii = ball_a->radius + ball_b->radius;
  } else if ((mesh_a != nullptr && ball_b != nullptr) || (ball_a != nullptr && mesh_b != nullptr)) {
    const PlacedBody& ball_body = ball_a != nullptr ? a : b;
    const PlacedBody& mesh_body = ball_a != nullptr ? b : a;
    const Sphere& ball = ball_a != nullptr ? *ball_a : *ball_b;
    std::vector<Triangle> surface;
    const Mesh& mesh = mesh_a != nullptr ? *mesh_a : *mesh_b;
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
      surface.push_back(place(mesh_body.pose, mesh.triangle(i)));
    return std::max(0.0, distance_to(surface, place(ball_body.pose, ball.centre)) - ball.radius);
  }
  if (!square) return std::nullopt;
  return std::max(0.0, rounded_root(*square) - radii);
}

double distance_tolerance(const PlacedBody& a, const PlacedBody& b) {
  const double largest = std::max(largest_of(a), largest_of(b));
  return kTouchTolerance * 4 * largest + kTouchUlps * 0x1p-52 * largest;
}

DistanceBounds distance_bounds(const PlacedBody& a, const PlacedBody& b) {
  if (const std::optional<double> exact = exact_distance(a, b)) return {*exact, *exact, 0, true};
  const ShapeDistance proposed = distance({a.shape, a.pose}, {b.shape, b.pose});
  const double tolerance = distance_tolerance(a, b);
  const bool are_there = outside_by(a.shape, a.pose, proposed.point_a) <= tolerance &&
                         outside_by(b.shape, b.pose, proposed.point_b) <= tolerance;
  return {.least = std::max(best_proved_gap(a, b, proposed.normal), 0.0),
          .most = are_there ? (proposed.point_a - proposed.point_b).norm()
                            : std::numeric_limits<double>::infinity(),
          .slack = tolerance};
}

std::string DistanceBounds::text() const {
  if (is_exact) return in_metres("exactly", least);
  std::string from = in_metres("a plane proves", least) + " at least";
  if (!std::isfinite(most)) return from;
  std::array<char, 24> to;
  std::snprintf(to.data(), to.size(), "%.2g", slack);
  return from + in_metres(", two points", most) + " at most, to " + to.data() + " m";
}

}  // namespace graze::compare
