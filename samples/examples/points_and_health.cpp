// Is a mesh sound, and where do points lie to it: one by one, or many at once.

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

int main() {
  const graze::Mesh cube = examples::cube(1);
  expect(graze::check(cube).is_healthy(), "closed, facing outwards, crossing itself nowhere");

  const std::vector<graze::TriangleIndices> torn(cube.triangles().begin(),
                                                 cube.triangles().end() - 1);
  const graze::MeshHealth health = graze::check({cube.vertices(), torn});
  expect(health.open_edges.size() == 3 && health.fault_count() == 3, "a triangle is missing");
  for (const graze::FaultyEdge& edge : health.open_edges)
    expect(edge.triangle < torn.size() && edge.triangle_count == 1, "and this is where");

  std::vector<graze::TriangleIndices> turned(cube.triangles().begin(), cube.triangles().end());
  for (graze::TriangleIndices& triangle : turned)
    std::swap(triangle[1], triangle[2]);
  const graze::MeshHealth inside_out = graze::check({cube.vertices(), turned});
  expect(inside_out.inside_out_parts.size() == 1, "all of it faces inwards");
  expect(inside_out.inside_out_parts[0].triangle_count == 12, "twelve triangles");

  // A point beside the placed cube, and one within it.
  const graze::PlacedMesh placed{cube, at(5, 0, 0)};
  const Eigen::Vector3d beside(5.5, 0.5, 1.5), within(5.5, 0.5, 0.75);
  const graze::NearestPoint nearest = graze::nearest_point(placed, beside);
  expect(nearest.distance == 0.5 && nearest.point.z() == 1, "half a metre above the top");
  expect(graze::signed_distance(placed, within) == -0.25, "a quarter of a metre below it");

  // Many, on all threads, each as if it were asked about alone.
  const std::vector<Eigen::Vector3d> points{beside, within};
  expect(graze::contains_points(placed, points) == std::vector<bool>{false, true}, "one is inside");
  expect(graze::nearest_points(placed, points)[0] == nearest, "the same, bit for bit");
  expect(graze::signed_distances(placed, points)[1] == -0.25, "likewise");

  // Or the rows of a matrix.
  Eigen::MatrixXd rows(2, 3);
  rows.row(0) = beside.transpose();
  rows.row(1) = within.transpose();
  expect(graze::signed_distances(placed, rows)[0] == 0.5, "as libigl and others keep points");
  expect(graze::contains_points(placed, rows, {.threads = 1})[1], "with the caller's thread alone");
  expect(graze::nearest_points(placed, rows)[1].distance == 0.25, "a quarter of a metre");
}
