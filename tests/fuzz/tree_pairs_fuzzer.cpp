#include <graze/bvh/error.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <tests/fuzz/byte_shapes.h>
#include <tests/shapes/random_meshes.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

// Laws 5 and 9: looks for a pair of triangles that a tree prunes and brute force finds. The meshes
// have inner nodes, and most poses bring them to within rounding of a touch: a point of one onto a
// point of the other, both outermost in opposite directions.

using namespace graze;
using Eigen::Vector3d;

namespace {

/// Below this, all distances are compared, too.
constexpr std::size_t kPairsForDistances = 200;

Mesh mesh_of(fuzz::ByteShapes& shapes) {
  RandomSource source(shapes.byte());
  const std::size_t count = shapes.byte() % 48 + 1u;
  const int kind = shapes.byte();
  Mesh mesh =
      kind % 3 == 0
          ? tests::lattice_soup(count, 1 + kind / 4 % 4, source)
          : tests::random_soup(
                {.count = count, .extent = 1, .size = std::ldexp(1, -(kind / 4 % 24))}, source);
  const double scale = std::ldexp(1, shapes.byte() % 128 - 64);
  const Triangle extra = shapes.triangle();
  std::vector<Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<TriangleIndices> triangles(mesh.triangles().begin(), mesh.triangles().end());
  const Vector3d offset = kind >= 128 ? extra.a : Vector3d(Vector3d::Zero());
  for (Vector3d& v : vertices)
    v = scale * v + offset;
  if (kind / 32 % 2 == 1) {  // any triangle at all, so that bounds are wide or lopsided
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {extra.a, extra.b, extra.c});
    triangles.push_back({first, first + 1, first + 2});
  }
  return Mesh(vertices, triangles);
}

Vector3d outermost(const Mesh& mesh, const Pose& pose, const Vector3d& direction) {
  Vector3d best = place(pose, mesh.triangle(0)).a;
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = place(pose, mesh.triangle(i));
    for (const Vector3d& p : {t.a, t.b, t.c}) {
      if (p.dot(direction) > best.dot(direction)) best = p;
    }
  }
  return best;
}

/// Any pose, or one in which B touches A from outside, up to rounding.
Pose pose_beside(fuzz::ByteShapes& shapes, const PlacedMesh& a, const Mesh& b) {
  Pose pose = shapes.pose();
  const int choice = shapes.byte();
  if (choice % 4 == 0) return pose;
  const double x = choice / 4 % 3 - 1, y = choice / 12 % 3 - 1, z = choice / 36 % 3 - 1;
  Vector3d direction(x, y, z);
  if (choice % 4 == 3) direction += Vector3d(pose.linear().col(0));  // along no axis of either
  pose.translation().setZero();
  const Vector3d shift =
      outermost(a.mesh, a.pose, direction) - outermost(b, pose, Vector3d(-direction));
  pose.translation() = shift;
  return pose;
}

std::vector<TrianglePair> pairs_by_force(const PlacedMesh& a, const PlacedMesh& b) {
  std::vector<TrianglePair> pairs;
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    const Triangle t = place(a.pose, a.mesh.triangle(i));
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      if (intersects(t, place(b.pose, b.mesh.triangle(j)))) pairs.push_back({i, j});
    }
  }
  return pairs;
}

bool is_distance_right(const PlacedMesh& a, const PlacedMesh& b,
                       const std::vector<TrianglePair>& meeting) {
  double least = HUGE_VAL;
  TrianglePair nearest{0, 0};
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    const Triangle t = place(a.pose, a.mesh.triangle(i));
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      const double found = distance(t, place(b.pose, b.mesh.triangle(j))).distance;
      if (found < least) nearest = {i, j};
      least = std::min(least, found);
    }
  }
  const MeshDistance found = distance(a, b);
  const bool is_right_pair = meeting.empty()
                                 ? found.pair == nearest
                                 : std::ranges::find(meeting, found.pair) != meeting.end();
  return found.distance == least && is_right_pair && within(a, b, least) &&
         (least == 0 || !within(a, b, std::nextafter(least, 0)));
}

[[noreturn]] void report(const char* what, const PlacedMesh& a, const PlacedMesh& b) {
  std::fprintf(stderr, "wrong: %s\n", what);
  for (const PlacedMesh* placed : {&a, &b}) {
    std::fputs("pose by columns:", stderr);
    for (int i = 0; i < 16; ++i)
      std::fprintf(stderr, " %a", placed->pose.data()[i]);
    for (const Vector3d& v : placed->mesh.vertices())
      std::fprintf(stderr, "\n  %a %a %a", v.x(), v.y(), v.z());
    std::fputc('\n', stderr);
  }
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes shapes(data, size);
  try {
    const Mesh mesh_a = mesh_of(shapes);
    const Mesh mesh_b = mesh_of(shapes);
    const PlacedMesh a{mesh_a, shapes.pose()};
    check_placement(a.pose, mesh_a.bounds(), "A");
    const PlacedMesh b{mesh_b, pose_beside(shapes, a, mesh_b)};
    check_placement(b.pose, mesh_b.bounds(), "B");
    const std::vector<TrianglePair> truth = pairs_by_force(a, b);
    for (const PairVolume volume : kPairVolumes) {
      if (find_triangle_pairs(a, b, {.volume = volume}).pairs != truth)
        report(name_of(volume), a, b);
      if (intersects(a, b, {.volume = volume}) == truth.empty()) report(name_of(volume), a, b);
    }
    const std::size_t pairs = mesh_a.triangles().size() * mesh_b.triangles().size();
    if (pairs <= kPairsForDistances && !is_distance_right(a, b, truth)) report("distance", a, b);
  } catch (const PoseError&) {
    // law 10 or law 1 refuses it
  } catch (const MeshError&) {
    // so is a coordinate that overflowed
  }
  return 0;
}
