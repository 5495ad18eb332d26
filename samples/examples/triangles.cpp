// Two triangles: do they touch or cross, what have they in common, how far apart; placed as queries
// place them.

#include <graze/engine/mesh/placement.h>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

int main() {
  const graze::Triangle flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const graze::Triangle upright{{0.25, 0.25, -1}, {0.25, 0.25, 1}, {0.25, 2, 0}};
  expect(graze::intersects(flat, upright), "exact for every finite double");
  expect(graze::crosses(flat, upright), "insides meet, and no plane holds both");
  expect(graze::intersects(flat, flat) && !graze::crosses(flat, flat),
         "a triangle only touches itself");
  expect(!graze::intersects(flat, flat, graze::Touch::Exclude), "either, as a policy says");

  const graze::TriangleIntersection shared = graze::intersection(flat, upright);
  expect(shared.kind == graze::IntersectionKind::Segment, "they share a segment");
  for (const Eigen::Vector3d& corner : shared)
    expect(corner.z() == 0, "in the plane of the first");

  const graze::Triangle above =
      graze::place(at(0, 0, 2), flat);  // as queries do, rounding included
  expect(above.a == graze::place(at(0, 0, 2), flat.a), "corner by corner");
  const graze::TriangleDistance gap = graze::distance(flat, above);
  expect(gap.distance == 2, "two metres apart");
  expect(gap.feature_a == graze::Feature::Vertex || gap.feature_a == graze::Feature::Edge ||
             gap.feature_a == graze::Feature::Face,
         "and in which part of each the nearest points lie");

  // What placing can come to is known from a box, and so what must be refused.
  const graze::Aabb bounds = graze::bounding_aabb(std::array{flat, above});
  expect(graze::largest_coordinates(at(0, 0, 2), bounds)[2] >= 4, "no placed z is beyond that");
  expect(graze::check_placement(at(0, 0, 2), bounds, "pose") == 0, "a translation is rigid");

  // Beside other sets, exactly as well.
  expect(graze::intersects(flat, graze::Aabb{{0.5, 0.5, 0}, {1, 1, 1}}), "a corner of the box");
  expect(graze::intersects(flat, graze::Sphere{{0, 0, 1}, 1}), "the ball touches it from above");
  // When they move, each vertex straight: the first contact, never late.
  const graze::TrianglePath floor{{flat.a, flat.a}, {flat.b, flat.b}, {flat.c, flat.c}};
  const graze::PointPath falling{{0.25, 0.25, 1}, {0.25, 0.25, -3}};
  const std::optional<graze::FirstContact> fallen = graze::first_contact(falling, floor);
  expect(fallen && fallen->time == 0.25 && !fallen->is_at_start, "after a quarter of the way");
  const graze::PointPath leaving{{0.25, 0.25, 0}, {0.25, 0.25, 1}};
  expect(graze::first_contact(leaving, floor)->is_at_start, "they touch before anything moves");
  expect(!graze::first_contact(leaving, floor, {.start = graze::StartContact::IsLeft}),
         "which a policy leaves out");
  const graze::EdgePath rail{floor.a, floor.b};
  const graze::EdgePath bar{{{0.5, -1, 1}, {0.5, -1, -1}}, {{0.5, 1, 1}, {0.5, 1, -1}}};
  expect(graze::first_contact(rail, bar)->time == 0.5, "two edges");
  std::optional<graze::FirstContact> both[2];
  graze::first_contacts(std::vector{rail, bar}, std::vector{bar, rail}, both);
  expect(both[0] == both[1] && both[0]->time == 0.5, "many at once, each as alone");
  const graze::TrianglePath panel{bar.a, bar.b, falling};
  expect(graze::first_contact(panel, floor)->time == 0.25, "two triangles: the vertex comes first");

  // When they come as near as half a metre, of two.
  expect(graze::first_contact(falling, floor, {.clearance = 0.5})->time < fallen->time,
         "as exactly, and never late");

  // And when one goes straight as it is.
  const std::optional<graze::FirstContact> landed = graze::cast(flat, above, {0, 0, -8});
  expect(landed && landed->time == 0.25, "a quarter of eight metres");
  expect(graze::cast(flat, graze::Sphere{{0.25, 0.25, 3}, 1}, {0, 0, -8})->time == 0.25, "a ball");

  const std::optional<graze::TriangleRayHit> hit =
      graze::cast_ray(flat, graze::Ray{{0.25, 0.25, 3}, {0, 0, -1}});
  expect(hit && hit->distance == 3 && hit->normal.z() == 1, "a ray from above");
}
