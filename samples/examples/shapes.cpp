// Any two shapes in poses: do they touch, how far apart, where; and shapes as a world asks them.

#include <cmath>
#include <string>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

int main() {
  const graze::Shape capsule = graze::Capsule{0.25, 0.5};
  expect(capsule.kind() == graze::ShapeKind::Capsule, "a shape is one of nine kinds");
  expect(std::string(graze::name_of(capsule.kind())) == "capsule", "which have names");
  expect(capsule.as<graze::Capsule>()->radius == 0.25, "its own numbers");
  expect(capsule.as<graze::Box>() == nullptr, "it is no box");
  expect(std::holds_alternative<graze::Capsule>(capsule.value()), "the same as a variant");
  expect(graze::pair_method(graze::ShapeKind::Sphere, graze::ShapeKind::Box) ==
             graze::PairMethod::ExactSphereBox,
         "how a pair is answered");

  // Each argument is a shape, or a shape and a pose.
  const graze::Pose aside = at(2, 0, 0);
  expect(!graze::intersects({graze::Box{{1, 1, 1}}}, {capsule, at(1.5, 0, 0)}), "apart");
  const graze::ShapeDistance gap = graze::distance({graze::Box{{1, 1, 1}}}, {capsule, aside});
  expect(std::abs(gap.distance - 0.75) < 1e-9, "three quarters of a metre");
  expect(gap.status == graze::PairStatus::Converged && gap.lower_bound <= gap.distance, "proved");

  const graze::Manifold manifold =
      graze::find_contacts({graze::Box{{1, 1, 1}}}, {graze::Box{{1, 1, 1}}, at(0, 0, 1.875)});
  expect(manifold.size() == 4, "face on face: four contacts");
  const graze::Manifold near = graze::find_contacts(
      {graze::Box{{1, 1, 1}}}, {graze::Box{{1, 1, 1}}, at(0, 0, 2.125)}, {.margin = 0.25});
  expect(near.size() == 4 && near[0].depth == -0.125, "and with a margin before they touch");
  expect(std::abs(manifold[0].depth - 0.125) < 1e-9 && manifold[0].normal.z() > 0.99, "upward");

  // Both in one number: positive apart, negative where they reach past each other.
  const graze::ShapeSeparation over =
      graze::find_separation({graze::Box{{1, 1, 1}}}, {graze::Box{{1, 1, 1}}, at(0, 0, 1.875)});
  expect(over.distance == -manifold[0].depth && over.normal == manifold[0].normal, "the deepest");
  const graze::ShapeSeparation apart =
      graze::find_separation({graze::Box{{1, 1, 1}}}, {capsule, aside});
  expect(apart.distance == gap.distance && apart.point_b == gap.point_b, "the distance");

  // A plank on two trestles, which are one mesh: it meets them in two regions of up to four
  // contacts.
  std::vector<Eigen::Vector3d> corners;
  std::vector<graze::TriangleIndices> triangles;
  for (const double x : {-3.0, 3.0}) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    const graze::Mesh trestle = examples::cube(1);
    for (const Eigen::Vector3d& corner : trestle.vertices())
      corners.push_back(corner + Eigen::Vector3d(x, 0, 0));
    for (const graze::TriangleIndices& t : trestle.triangles())
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  const graze::Mesh trestles(corners, std::span<const graze::TriangleIndices>(triangles));
  const graze::Aabb around = trestles.bounds();
  const graze::Manifold lying = graze::find_contacts(
      {graze::Box{{3.25, 0.25, 0.125}}, at(0, 0, around.max.z() + 0.0625)}, {trestles});
  expect(lying.region_count() == 2, "one for each trestle");
  for (std::size_t region = 0; region < lying.region_count(); ++region) {
    for (const graze::ShapeContact& contact : lying.region(region))
      expect(std::abs(contact.depth - 0.0625) < 1e-9 && contact.normal.z() < -0.99, "downward");
  }

  const graze::Aabb box_a = graze::bounding_aabb({capsule});
  const graze::Aabb box_b = graze::bounding_aabb({capsule, aside});
  const graze::BoxGap between = graze::gap_between(box_a, box_b);
  expect(between.axis == 0 && between.is_a_below && between.gap > 1.49, "1.5 m along x");
  expect(graze::check_pose(aside, "pose") == 0, "a translation is rigid");

  // As a world asks it; classes of a user's own may do the same.
  const std::shared_ptr<const graze::BodyShape> body = graze::share(capsule);
  expect(body->shape()->kind() == graze::ShapeKind::Capsule, "the shape that it stands for");
  expect(body->allows_concurrent_calls(), "threads may ask it at once");
  expect(body->bounds(aside) == box_b, "its box");
  expect(body->bounding_radius() >= 0.75, "no point is further from its origin");
  expect(!body->touches(at(0, 0, 0), *body, aside), "apart");
  expect(body->gap(at(0, 0, 0), *body, aside) <= 1.5, "by what is known, if anything is");
  expect(body->contacts(at(0, 0, 0), *body, aside).empty(), "so there is no contact");
  expect(!body->contacts_within(at(0, 0, 0), *body, aside, 1.75).empty(), "but with a margin");
  expect(body->meet(at(0, 0, 0), *body, at(0.25, 0, 0)).has_value(), "both at once");
  expect(body->cast_ray(aside, {{0, 0, 0}, {1, 0, 0}}).has_value(), "a ray meets it");

  expect(graze::lets_pass({.category = 1}, {.mask = 1}), "filters that let two bodies meet");
  expect(!graze::lets_pass({.group = -1}, {.group = -1}), "and that do not");
}
