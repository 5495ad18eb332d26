// Two placed meshes: do they touch, in which triangles, how far apart; for many poses, and along a
// motion.

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

int main() {
  const graze::Mesh cube = examples::cube(1);
  const graze::Mesh small = examples::cube(0.25);
  graze::prepare(cube);  // builds its tree now; queries would do so when they need it

  expect(graze::intersects({cube}, {cube, at(1, 0, 0)}), "touching counts");
  expect(!graze::intersects({cube}, {cube, at(1, 0, 0)}, {.hit = graze::Hit::Crossing}),
         "face on face nothing crosses");
  expect(!graze::intersects({cube}, {small, at(0.25, 0.25, 0.25)}), "meshes are surfaces");
  expect(graze::intersects({cube}, {small, at(0.25, 0.25, 0.25)}, {.hit = graze::Hit::Solid}),
         "unless they are said to be solid");

  const graze::TrianglePairs pairs = graze::find_triangle_pairs({cube}, {cube, at(0.5, 0.5, 0.5)});
  expect(!pairs.empty() && pairs.completeness == graze::Completeness::Complete, "all pairs");
  expect(graze::find_triangle_pairs({cube}, {cube, at(0.5, 0.5, 0.5)}, {.threads = 0}) == pairs,
         "the same from all threads");
  expect(graze::find_triangle_pairs({cube}, {cube, at(0.5, 0.5, 0.5)}, {.limit = 2}).size() == 2,
         "or as many as are asked for");

  const graze::MeshDistance gap = graze::distance({cube}, {cube, at(3, 0, 0)});
  expect(gap.distance == 2 && gap.point_a.x() == 1 && gap.point_b.x() == 3, "2 m along x");
  expect(graze::within({cube}, {cube, at(3, 0, 0)}, 2), "at most 2 m apart");
  expect(!graze::within({cube}, {cube, at(3, 0, 0)}, 1.99), "but not less");

  // As open solids: cubes that lie against each other do not overlap, equal ones do.
  expect(!graze::interiors_intersect({cube}, {cube, at(1, 0, 0)}), "wall against wall");
  expect(graze::interiors_intersect({cube}, {cube, at(0.5, 0, 0)}), "four faces in one plane each");
  expect(graze::interiors_intersect({cube}, {cube}), "no two of their triangles cross");

  // One answer for each pose, on all threads.
  const std::vector<graze::Pose> poses{at(0.5, 0.5, 0.5), at(3, 0, 0)};
  expect(graze::intersects({cube}, {cube, poses}) == std::vector<bool>{true, false}, "yes and no");
  expect(graze::find_triangle_pairs({cube}, {cube, poses})[0] == pairs, "pairs likewise");
  expect(graze::distance({cube}, {cube, poses})[1] == gap, "and distances");

  // Along a motion a memory saves what the last pose has shown, and changes no answer.
  graze::PairMemory memory;
  graze::Work work;
  for (double x = 3; x > 2; x -= 0.125)
    expect(!graze::intersects({cube}, {cube, at(x, 0, 0)}, memory, {}, &work), "apart on its way");
  expect(memory.still_apart() > 0, "the first gap outlasts steps of the motion");
  expect(work.skipped_by_memory > 0, "which the counters tell, too");
  for (double x = 0.5; x > 0.25; x -= 0.0625)
    expect(graze::intersects({cube}, {cube, at(x, x, x)}, memory), "it has come to touch");
  expect(memory.still_touching() > 0, "triangles that touched still do");
  expect(graze::distance({cube}, {cube, at(3, 0, 0)}, memory).distance == 2, "distances likewise");

  // Boxes and balls beside a mesh.
  const graze::Aabb corner{{0.9, 0.9, 0.9}, {1.1, 1.1, 1.1}};
  expect(graze::intersects(cube, corner), "the box holds a corner of the cube");
  expect(graze::find_triangles(cube, corner).size() >= 3, "in which three faces meet");
  expect(!graze::intersects(cube, graze::Sphere{{0.5, 0.5, 0.5}, 0.25}), "a ball wholly inside");
}
