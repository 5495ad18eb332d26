#include <graze/engine/compare/judge/bodies/body_judges.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

/// distance() of shapes promises 2^-34 of the scale of the pair.
constexpr double kPromise = 0x1p-34;

/// Normals are unit to some ulp. Of a search that did not end kShapeTolerance is asked.
constexpr double kUnitTolerance = 0x1p-48;

bool is(const PlacedBody& body, ShapeKind kind) {
  return body.shape.kind() == kind;
}

double largest_of(const PlacedBody& body) {
  if (const auto plane = flat_of(body.shape))
    return body.pose.translation().cwiseAbs().maxCoeff() + std::abs(plane->offset);
  const Aabb box = bounding_aabb({body.shape, body.pose});
  return std::max({box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff(),
                   body.pose.translation().cwiseAbs().maxCoeff()});
}

/// By how much a plane across the unit direction has A behind it and B before it.
double gap_along(const PlacedBody& a, const PlacedBody& b, const Vector3d& n) {
  const double gap = -support_along(b.shape, b.pose, -n) - support_along(a.shape, a.pose, n);
  return std::isnan(gap) ? -std::numeric_limits<double>::infinity() : gap;
}

/// The distance where it is a matter of points and triangles, rounded.
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

/// What is known of the distance of two convex shapes that are apart.
struct Proved {
  double least;  ///< a plane has them so far on different sides
  double most;   ///< two points of them are so near; infinite: none are known
};

/// The library proposes a direction and two points; what the shapes are decides what these prove.
Proved prove(const PlacedBody& a, const PlacedBody& b, double tolerance) {
  const ShapeDistance proposed = distance({a.shape, a.pose}, {b.shape, b.pose});
  const bool are_there = outside_by(a.shape, a.pose, proposed.point_a) <= tolerance &&
                         outside_by(b.shape, b.pose, proposed.point_b) <= tolerance;
  return {.least = gap_along(a, b, proposed.normal),
          .most = are_there ? (proposed.point_a - proposed.point_b).norm()
                            : std::numeric_limits<double>::infinity()};
}

/// Of a number alone, without points and a normal that would show it.
PartsReview review_number(const PlacedBody& a, const PlacedBody& b, double claimed,
                          double tolerance) {
  const Proved proved = prove(a, b, tolerance);
  if (claimed < proved.least - tolerance)
    return {.fault = WitnessFault{"nearer than a plane lets them be", proved.least - claimed}};
  if (claimed > proved.most + tolerance)
    return {.fault = WitnessFault{"two points are nearer", claimed - proved.most}};
  if (proved.least >= claimed - tolerance && proved.most <= claimed + tolerance) return {};
  return {.unjudged = "that nothing is nearer"};
}

}  // namespace

PartsReview review_distance(const PlacedBody& a, const PlacedBody& b, const CaseAnswer& answer) {
  const auto fault = [](const char* what, double error) {
    return PartsReview{.fault = WitnessFault{what, error}};
  };
  const double claimed = *answer.distance;
  if (claimed < 0) return fault("a distance below zero", -claimed);
  const double largest = std::max(largest_of(a), largest_of(b));
  const double slack = kTouchUlps * 0x1p-52 * largest;
  const bool has_ended = answer.is_converged.value_or(true);
  const double tolerance = (has_ended ? kPromise : kShapeTolerance) * 4 * largest + slack;
  const bool is_apart = claimed > 0;
  if (const std::optional<double> exact = exact_distance(a, b)) {
    if (std::abs(*exact - claimed) > slack)
      return fault("another distance", std::abs(*exact - claimed));
  }
  if (answer.point_a && answer.point_b) {
    const double between = (*answer.point_a - *answer.point_b).norm();
    if (std::abs(between - claimed) > tolerance)
      return fault("points that are not so far apart", std::abs(between - claimed));
    // Of intersecting shapes it is a point in both; of a mesh, a surface, near what is met.
    const bool has_mesh = is(a, ShapeKind::Mesh) || is(b, ShapeKind::Mesh);
    for (const PlacedBody* body : {&a, &b}) {
      const double off =
          outside_by(body->shape, body->pose, body == &a ? *answer.point_a : *answer.point_b);
      if (off > tolerance && (is_apart || !has_mesh))
        return fault(body == &a ? "point_a is off A" : "point_b is off B", off);
      if (is_apart && off < -tolerance)
        return fault(body == &a ? "point_a is inside A" : "point_b is inside B", -off);
    }
  }
  if (answer.normal) {
    const double off_unit = std::abs(answer.normal->norm() - 1);
    if (!(off_unit <= kUnitTolerance)) return fault("a normal of another length", off_unit);
  }
  if (answer.lower_bound && *answer.lower_bound > claimed + slack)
    return fault("a lower bound above the distance", *answer.lower_bound - claimed);
  if (!is_apart) {  // whether they meet was judged before
    return answer.normal ? PartsReview{.unjudged = "the normal of what meets"} : PartsReview{};
  }
  if (answer.normal && answer.point_a && answer.point_b) {
    // Whatever the shapes are: the normal leads from A to B.
    const double along = answer.normal->dot(*answer.point_b - *answer.point_a);
    if (along < -tolerance) return fault("a normal from B to A", -along);
  }
  double proved = -std::numeric_limits<double>::infinity();
  if (answer.normal) proved = gap_along(a, b, *answer.normal);
  const bool are_convex = !is(a, ShapeKind::Mesh) && !is(b, ShapeKind::Mesh);
  if (are_convex && answer.lower_bound && answer.normal &&
      *answer.lower_bound > std::max(proved, 0.0) + slack) {
    return fault("a lower bound that its normal does not prove", *answer.lower_bound - proved);
  }
  if (answer.point_a && answer.point_b && claimed > tolerance)
    proved = std::max(proved, gap_along(a, b, (*answer.point_b - *answer.point_a).normalized()));
  if (exact_distance(a, b) || proved >= claimed - tolerance) return {};
  if (are_convex && answer.is_converged.value_or(false))
    return fault("a distance that no plane proves", claimed - std::max(proved, 0.0));
  if (are_convex) return review_number(a, b, claimed, tolerance);
  return {.unjudged = "that nothing is nearer"};
}

}  // namespace graze::compare
