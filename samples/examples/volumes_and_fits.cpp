// Bounding volumes: fitted to points and triangles, measured, joined, tested against each other and
// against points.

#include <cmath>
#include <string>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

namespace {

void fit_points(std::span<const Eigen::Vector3d> points) {
  const graze::Aabb box = graze::bounding_aabb(points);
  expect(box == graze::Aabb{{0, 0, 0}, {1, 1, 1}} && graze::volume(box) == 1, "exactly");
  expect(graze::surface(box) == 6, "six square metres");
  expect(graze::merged(box, {{2, 0, 0}, {3, 1, 1}}).max.x() == 3, "around both");

  const graze::Sphere ball = graze::bounding_sphere(points);  // the smallest
  expect(graze::ritter_sphere(points).radius >= ball.radius, "faster, and a little larger");
  expect(graze::merged(ball, {{0.5, 0.5, 0.5}, 0.25}).radius == ball.radius, "one holds the other");

  const graze::Obb tight = graze::bounding_obb(points);
  expect(graze::volume(graze::covariance_box(points)) >= graze::volume(tight) * (1 - 1e-9),
         "linear");
  expect(graze::volume(graze::ditetrahedron_box(points)) >= graze::volume(tight) * (1 - 1e-9),
         "fast");
  expect(graze::volume(graze::merged(tight, tight)) > 0.99, "around both, rounded outward");

  const graze::KDop<18> kdop = graze::bounding_kdop(points);
  expect(graze::merged(kdop, kdop) == kdop, "slab by slab");
}

void fit_triangles(std::span<const graze::Triangle> triangles) {
  expect(graze::volume(graze::bounding_aabb(triangles)) <= 1, "the same of triangles");
  expect(graze::bounding_sphere(triangles).radius <= graze::ritter_sphere(triangles).radius,
         "here too");
  expect(graze::volume(graze::bounding_obb(triangles)) < 0.01, "flat ones have a flat box");
  expect(graze::volume(graze::covariance_box(triangles)) < 0.01, "by the axes of their surface");
  expect(graze::volume(graze::ditetrahedron_box(triangles)) < 0.01, "or by their edges");
  expect(graze::bounding_kdop(triangles).min[2] == 0, "and a flat slab");
}

void test_volumes() {
  const graze::Aabb box{{0, 0, 0}, {1, 1, 1}};
  const graze::Obb turned{at(2, 0.5, 0.5), {1, 1, 1}};
  const graze::Sphere ball{{2, 0.5, 0.5}, 1};
  expect(graze::intersects(box, turned) && graze::intersects(ball, box), "touching counts");
  expect(
      !graze::intersects(graze::HollowSphere{ball}, graze::Aabb{{1.9, 0.4, 0.4}, {2.1, 0.6, 0.6}}),
      "the surface of a ball misses a box inside it");
  expect(graze::intersects(graze::Ellipsoid{{3, 0.5, 0.5}, {2, 1, 1}}, box), "an ellipsoid");
  expect(graze::contains(box, Eigen::Vector3d(1, 1, 1)), "a closed box has its corners");
  expect(graze::contains(turned, Eigen::Vector3d(2, 0, 0)), "a point in an oriented box");
  expect(graze::contains(ball, Eigen::Vector3d(3, 0.5, 0.5)), "or on a ball");

  // What every function checks of its arguments; each throws InputError, which begins with the
  // word.
  graze::check_box(box, "box");
  graze::check_box(turned, "oriented box");
  graze::check_sphere(ball, "ball");
  graze::check_ellipsoid({{0, 0, 0}, {1, 1, 1}}, "ellipsoid");
  graze::check_kdop(graze::bounding_kdop(std::array{box.min, box.max}), "k-DOP");
}

}  // namespace

int main() {
  const graze::Mesh cube = examples::cube(1);
  fit_points(cube.vertices());
  fit_triangles(std::array{cube.triangle(0), cube.triangle(1)});
  test_volumes();
  expect(std::string(graze::name_of(graze::Volume::KDop)) == "kdop", "kinds of volumes have names");
  expect(graze::binary_volume(graze::PairVolume::Obb) == graze::Volume::Obb, "of either tree");
}
