// Convex hulls of points, and rays at hulls, meshes and other shapes.

#include <cmath>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

int main() {
  const graze::Mesh cube = examples::cube(1);
  std::vector<Eigen::Vector3d> points(cube.vertices().begin(), cube.vertices().end());
  points.push_back(Eigen::Vector3d(0.5, 0.5, 0.5));  // inside: no corner of the hull
  const graze::ConvexHull hull(points);
  expect(hull.vertex_count() == 8 && hull.face_count() == 6, "the hull of a cube is a cube");
  expect(hull.facet_count() == 6 && hull.facet(0).size() == 4,
         "its facets are squares of vertices");
  for (std::size_t i = 0; i < hull.vertex_count(); ++i)
    expect(hull.vertex(i).cwiseAbs().maxCoeff() <= 1 + 1e-12, "its corners are points of ours");
  expect(graze::intersects({hull}, {hull, at(1, 0, 0)}), "hulls are shapes");

  const graze::Ray down{.origin = {0.25, 0.5, 3}, .direction = {0, 0, -2}, .max_distance = 10};
  graze::check_ray(down, "ray");  // as every query does; throws InputError

  // The first triangle of a mesh, and all of them.
  const std::optional<graze::RayHit> first = graze::cast_ray(cube, down);
  expect(first && first->distance == 2 && first->normal.z() == 1, "two metres down to the top");
  const std::vector<graze::RayHit> all = graze::cast_ray_all(cube, down);
  expect(all.size() == 2 && all[1].distance == 3, "and out through the bottom");
  expect(!graze::cast_ray({cube, at(2, 0, 0)}, down), "a mesh in a pose, which it misses");
  expect(graze::intersects(cube, down), "whether there is any");

  // Many rays a call, which takes less time for each.
  std::vector<std::optional<graze::RayHit>> hits;
  graze::cast_rays(cube, std::vector<graze::Ray>{down, {{2, 0, 3}, {0, 0, -1}}}, hits);
  expect(hits[0] == first && !hits[1], "the first of each, if any");

  // Solid shapes: a ray that begins inside meets them there.
  const std::optional<graze::RayHit> at_hull = graze::cast_ray({hull}, down);
  expect(at_hull && std::abs(at_hull->distance - 2) < 1e-12, "the hull is met where the mesh is");
  expect(at_hull->triangle == graze::kNoTriangle, "but has no triangles");
  const std::optional<graze::RayHit> inside = graze::cast_ray({graze::Sphere{{0, 0, 3}, 1}}, down);
  expect(inside && inside->distance == 0, "from within a ball");
  expect(!graze::cast_ray({hull}, {down.origin, down.direction, 1}), "a ray that ends before");
}
