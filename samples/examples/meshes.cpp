// Meshes: made from arrays and from matrices, what they consist of, what they form, and deformed.

#include <cmath>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

namespace {

void what_it_is(const graze::Mesh& cube) {
  expect(cube.vertices().size() == 8 && cube.triangles().size() == 12, "a cube has 12 triangles");
  expect(cube.bounds() == graze::Aabb{{0, 0, 0}, {1, 1, 1}}, "bounds are exact");

  // Matrices of three columns, as libigl and others have them, and back.
  const Eigen::MatrixXd vertices = 2 * cube.vertex_matrix();
  const Eigen::MatrixXi triangles = cube.triangle_matrix().cast<int>();
  const graze::Mesh twice(vertices, triangles);
  expect(twice.triangle(0).c == 2 * cube.triangle(0).c, "the same cube, twice as large");

  // A copy is a handle to the same data; equal data of its own is another mesh.
  const graze::Mesh copy = cube;
  expect(copy == cube && !(twice == cube), "copies are handles");

  // What its triangles form once equal positions are one vertex.
  const graze::Topology& topology = cube.topology();
  expect(topology.is_closed && topology.components == 1, "a cube is closed and connected");
  expect(cube.component_vertices().size() == 1, "one vertex of each component");
  expect(cube.welded()[7] == 7, "no other vertex is where the last one is");
  expect(std::abs(graze::signed_volume(cube) - 1) < 1e-12, "it encloses a cubic metre");
  expect(graze::contains({cube, examples::at(5, 0, 0)}, Eigen::Vector3d(5.5, 0.5, 0.5)),
         "a point inside the placed cube");

  expect(!graze::self_intersects(cube), "no triangles cross");
  expect(graze::find_self_pairs(cube).empty(), "so there are no pairs that do");
  expect(!graze::find_self_pairs(cube, {.kind = graze::SelfPairKind::Neighbour}).empty(),
         "but neighbours share vertices and edges");

  // Volumes around it, and how well they fit.
  expect(std::abs(graze::bounding_sphere(cube).radius - std::sqrt(0.75)) < 1e-12,
         "the smallest ball");
  expect(graze::volume(graze::bounding_obb(cube)) < 1 + 1e-12, "the smallest box");
  expect(graze::bounding_kdop(cube).max[3] == 2, "x + y is at most 2");
  const graze::MeshFit fit = graze::measure_fit(cube);
  expect(fit.volumes[0].type == graze::Volume::Aabb, "four kinds of volumes, the boxes first");
  expect(fit.volumes[1].empty_share > 0.6, "most of a ball around a cube is empty");
}

void deformed(const graze::Mesh& cube) {
  // The same triangles with vertices elsewhere: trees are fitted, not built.
  std::vector<Eigen::Vector3d> higher(cube.vertices().begin(), cube.vertices().end());
  for (Eigen::Vector3d& vertex : higher)
    vertex.z() *= 3;
  const graze::Mesh tower = cube.deformed(higher);
  expect(std::abs(graze::signed_volume(tower) - 3) < 1e-12, "three times as high");

  // On the way there each vertex goes straight: when does the tower meet what is above?
  const graze::MeshPath growing(cube, tower);
  std::vector<Eigen::Vector3d> raised(cube.vertices().begin(), cube.vertices().end());
  for (Eigen::Vector3d& vertex : raised)
    vertex.z() += 2;
  const graze::Mesh lid = cube.deformed(raised);
  const graze::MeshPath resting(lid, lid);
  const std::optional<graze::MeshFirstContact> met = graze::first_contact(growing, resting);
  expect(met && met->time == 0.5 && !met->is_at_start, "one metre of two: never late");
  const auto all = graze::find_contacts_in_step(growing, resting);
  expect(all.size() > 4 && all[0].time == 0.5, "and all features that meet in the step");
  expect(graze::find_self_contacts_in_step(growing).empty(), "none of its own");
  const auto near = graze::first_contact(growing, resting, {.clearance = 0.125});
  expect(near && near->time < met->time, "the largest step that keeps an eighth of a metre");
  expect(growing.start() == cube && growing.end() == tower && growing.bytes() > 0,
         "it holds both meshes, and a tree");
  expect(!graze::first_self_contact(growing), "and no part of it meets another");
}

/// A mesh that goes straight as it is.
void cast(const graze::Mesh& cube) {
  // Along two metres down, from one metre above.
  const std::optional<graze::MeshCast> landed =
      graze::cast({cube}, {cube, at(0, 0, 2)}, Eigen::Vector3d(0, 0, -2));
  expect(landed && landed->time == 0.5 && landed->normal.z() == 1, "it lands on the other's top");
  const Eigen::Vector3d up(0, 0, 1);
  expect(graze::cast({cube}, {cube, at(0, 0, 1)}, up)->is_at_start, "what rests there touches");
  expect(!graze::cast({cube}, {cube, at(0, 0, 1)}, up, {.start = graze::StartContact::IsLeft}),
         "which a policy leaves out, so that it may leave");
  const std::optional<graze::VolumeCast> dropped =
      graze::cast({cube}, graze::Aabb{{-0.1, -0.1, 1.5}, {0.1, 0.1, 2}}, Eigen::Vector3d(0, 0, -4));
  expect(dropped && dropped->time == 0.125 && dropped->point.z() == 1, "a box that goes down");
  expect(graze::cast({cube}, graze::Obb{at(0, 0, 3), {1, 1, 1}}, Eigen::Vector3d(0, 0, -4))->time ==
             0.25,
         "or one with axes of its own");
  const std::optional<graze::VolumeCast> ball =
      graze::cast({cube}, graze::Sphere{{0, 0, 2.5}, 0.5}, Eigen::Vector3d(0, 0, -4));
  expect(ball && ball->time == 0.25 && ball->normal.z() == 1, "a ball");
}

}  // namespace

int main() {
  const graze::Mesh cube = examples::cube(1);  // from two arrays
  what_it_is(cube);
  deformed(cube);
  cast(cube);
}
