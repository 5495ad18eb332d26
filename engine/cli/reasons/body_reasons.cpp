#include <graze/bvh/error.h>
#include <graze/engine/cli/reasons/reasons.h>
#include <graze/engine/compare/judge/bodies/distance_bounds.h>
#include <graze/engine/compare/judge/bodies/least_parting.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace graze::cli {
namespace {

using compare::PlacedBody;
using Eigen::Vector3d;

/// Both bounds of a shortest translation are sought to this share of the largest coordinate.
constexpr double kNearEnough = 1e-9;

bool is_surface(const PlacedBody& body) {
  return body.shape.kind() == ShapeKind::Mesh || body.shape.kind() == ShapeKind::HeightField;
}

/// Returns the direction across which a plane parts the two most: that of the nearest points, or an
/// axis of one of them.
Vector3d best_direction(const PlacedBody& a, const PlacedBody& b, const Vector3d& proposed) {
  Vector3d best = proposed;
  for (const PlacedBody* body : {&a, &b}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        const Vector3d n = sign * body->pose.linear().col(axis);
        if (proved_gap(a, b, n) > proved_gap(a, b, best)) best = n;
      }
    }
  }
  return best;
}

/// Turns the direction to that of a half-space or a plane, which part others across their own
/// direction alone.
Vector3d turned_to_flat(const PlacedBody& a, const PlacedBody& b, const Vector3d& n) {
  if (const auto flat = compare::flat_of(a.shape)) return a.pose.linear() * flat->normal;
  if (const auto flat = compare::flat_of(b.shape)) return -(b.pose.linear() * flat->normal);
  return n;
}

void add_plane(const PlacedBody& a, const PlacedBody& b, const ShapeDistance& found, Reasons& all) {
  const Vector3d n = turned_to_flat(a, b, best_direction(a, b, found.normal));
  const double end_a = compare::support_along(a.shape, a.pose, n);
  const double begin_b = -compare::support_along(b.shape, b.pose, -n);
  if (!(begin_b > end_a)) {
    all.push_back(
        "No plane was found that has the two on different sides: one is in a hollow of the other, "
        "or they are nearer than rounding tells.");
    return;
  }
  all.push_back(fmt::format(
      "A plane parts them. Measured along the direction {}, all of A ends at {:.12g} m and all of "
      "B begins at {:.12g} m, so that a gap of {:.6g} m is left, and they are no nearer than that.",
      words_of(n), end_a, begin_b, begin_b - end_a));
}

void add_points(const ShapeDistance& found, Reasons& all) {
  all.push_back(fmt::format(
      "Two points are as near: {} on A and {} on B are {:.12g} m apart, so that the "
      "two are no further apart than that.",
      words_of(found.point_a), words_of(found.point_b), (found.point_a - found.point_b).norm()));
}

void add_common_point(const PlacedBody& a, const PlacedBody& b, const ShapeDistance& found,
                      Reasons& all) {
  const Vector3d& point = found.point_a;
  const double outside_a = compare::outside_by(a.shape, a.pose, point);
  const double outside_b = compare::outside_by(b.shape, b.pose, point);
  const auto where = [](double outside) {
    return outside < 0 ? fmt::format("{:.3g} m below the surface", -outside)
                       : fmt::format("at the surface to {:.3g} m", outside);
  };
  all.push_back(fmt::format("They share the point {}: of A it is {}, of B {}.", words_of(point),
                            where(outside_a), where(outside_b)));
}

void add_way_out(const PlacedBody& a, const PlacedBody& b, Reasons& all) {
  if (compare::flat_of(a.shape) && compare::flat_of(b.shape)) return;
  const Manifold contacts = find_contacts({a.shape, a.pose}, {b.shape, b.pose});
  if (contacts.empty()) return;
  all.push_back(
      fmt::format("They are {:.6g} m deep in each other: moved by that along {}, B is free of A.",
                  contacts[0].depth, words_of(contacts[0].normal)));
}

void add_meshes(const PlacedMeshView& a, const PlacedMeshView& b, Reasons& all) {
  const TrianglePairs hits = find_triangle_pairs(a, b, {.limit = 1});
  if (!hits.empty()) {
    all.push_back(fmt::format("Triangle {} of A and triangle {} of B share a point, exactly.",
                              hits[0].a, hits[0].b));
    return;
  }
  const MeshDistance gap = distance(a, b);
  all.push_back(fmt::format(
      "The nearest triangles are {} of A and {} of B, {:.6g} m apart, between {} "
      "and {}.",
      gap.pair.a, gap.pair.b, gap.distance, words_of(gap.point_a), words_of(gap.point_b)));
}

/// Adds how far B must go; a plane and two points prove nothing about contacts.
void add_claimed_depth(const PlacedBody& a, const PlacedBody& b, const CaseAnswer& answer,
                       Reasons& all) {
  if (!answer.manifold || answer.manifold->empty()) return;
  const CaseShapeContact& deepest = *std::max_element(
      answer.manifold->begin(), answer.manifold->end(),
      [](const CaseShapeContact& x, const CaseShapeContact& y) { return x.depth < y.depth; });
  const double needed = compare::support_along(a.shape, a.pose, deepest.normal) +
                        compare::support_along(b.shape, b.pose, -deepest.normal);
  if (!std::isfinite(needed)) return;
  all.push_back(fmt::format(
      "The deepest contact of the answer says that B must go {:.6g} m along {}; a plane "
      "across that direction parts them once it has gone {:.6g} m.",
      deepest.depth, words_of(deepest.normal), needed));
}

/// Adds how far B must go along the answer, and how far along the shortest direction, by planes.
void add_claimed_translation(const PlacedBody& a, const PlacedBody& b, const CaseAnswer& answer,
                             Reasons& all) {
  const double length = answer.translation->norm();
  if (length > 0) {
    const Vector3d n = *answer.translation / length;
    const double needed =
        compare::support_along(a.shape, a.pose, n) + compare::support_along(b.shape, b.pose, -n);
    all.push_back(fmt::format("The answer moves B by {:.12g} m along {}.", length, words_of(n)));
    if (std::isfinite(needed) && needed >= 0)
      all.push_back(fmt::format(
          "A plane across that direction parts them once B has gone {:.12g} m.", needed));
  } else {
    all.push_back("The answer moves B not at all.");
  }
  const double size = std::max(compare::largest_of(a), compare::largest_of(b));
  const auto shortest = compare::least_parting(a, b, *answer.translation, kNearEnough * size);
  if (!shortest || !(shortest->most >= 0)) return;
  all.push_back(fmt::format(
      "Of all directions that were tried {} is the shortest: a plane across it parts them after "
      "{:.12g} m.",
      words_of(shortest->direction), shortest->most));
  if (is_surface(a) || is_surface(b)) {
    all.push_back("A surface may also be left to its inside, so that no plane proves a least way.");
  } else {
    all.push_back(
        fmt::format("Planes across all other directions prove that none is shorter than {:.12g} m.",
                    std::max(shortest->least, 0.0)));
  }
}

}  // namespace

Reasons place_reasons(const Case& query) {
  Reasons all;
  if (const auto meshes = compare::as_meshes(query)) {
    add_meshes({meshes->a.mesh, meshes->a.pose}, {meshes->b.mesh, meshes->b.pose}, all);
    return all;
  }
  const auto bodies = compare::as_bodies(query);
  if (!bodies) return all;
  const PlacedBody a{bodies->a.shape, bodies->a.pose};
  const PlacedBody b{bodies->b.shape, bodies->b.pose};
  const ShapeDistance found = distance({a.shape, a.pose}, {b.shape, b.pose});
  if (found.distance > 0) {
    add_plane(a, b, found, all);
    add_points(found, all);
  } else {
    add_common_point(a, b, found, all);
    add_way_out(a, b, all);
  }
  return all;
}

/// Says where the two stand, and where they do once B has moved.
Reasons separation_reasons(const Case& query, const compare::Judgement& judgement) {
  Reasons all = place_reasons(query);
  const compare::MeshCase meshes = *compare::as_meshes(query);
  const Vector3d& by = *query.answer->translation;
  all.push_back(fmt::format("The answer says that B is apart {:.12g} m away, moved by {}.",
                            *query.answer->distance, words_of(by)));
  Pose moved = meshes.b.pose;
  moved.translation() += by;
  try {
    Reasons there;
    add_meshes({meshes.a.mesh, meshes.a.pose}, {meshes.b.mesh, moved}, there);
    all.push_back("Moved like that: " + there.front());
  } catch (const Error&) {
    all.push_back("Moved like that, B is out of the range of double.");
  }
  if (judgement.verdict == compare::Verdict::Wrong) all.push_back(words_of_error(judgement));
  return all;
}

Reasons body_reasons(const Case& query, const compare::Judgement& judgement) {
  Reasons all = place_reasons(query);
  const CaseAnswer& answer = *query.answer;
  if (query.ask == Ask::Within)
    all.push_back(
        fmt::format("The clearance that was asked for is {:.12g} m.", query.settings.clearance));
  if (query.ask == Ask::Distance && answer.distance)
    all.push_back(fmt::format("The answer says {:.12g} m.", *answer.distance));
  if (query.ask == Ask::Contacts) {
    const compare::BodyCase bodies = *compare::as_bodies(query);
    add_claimed_depth({bodies.a.shape, bodies.a.pose}, {bodies.b.shape, bodies.b.pose}, answer,
                      all);
  }
  if (query.ask == Ask::Separation && answer.translation) {
    const compare::BodyCase bodies = *compare::as_bodies(query);
    add_claimed_translation({bodies.a.shape, bodies.a.pose}, {bodies.b.shape, bodies.b.pose},
                            answer, all);
  }
  if (judgement.verdict == compare::Verdict::Wrong) all.push_back(words_of_error(judgement));
  return all;
}

}  // namespace graze::cli
