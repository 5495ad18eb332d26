#include <graze/bvh/error.h>
#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <tests/fuzz/byte_shapes.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

// Laws 1, 5 and 9: whatever two poses do to two small meshes, and whatever volumes prune, a query
// finds those pairs of placed triangles that the referee finds one by one.

using namespace graze;

namespace {

/// Up to four triangles, each with vertices of its own.
Mesh small_mesh(fuzz::ByteShapes& shapes) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  const std::uint32_t count = shapes.byte() % 4 + 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Triangle t = shapes.triangle();
    vertices.insert(vertices.end(), {t.a, t.b, t.c});
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return Mesh(vertices, triangles);
}

std::vector<TrianglePair> true_pairs(const PlacedMesh& a, const PlacedMesh& b) {
  std::vector<TrianglePair> pairs;
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      if (compare::referee_intersects(place(a.pose, a.mesh.triangle(i)),
                                      place(b.pose, b.mesh.triangle(j)))) {
        pairs.push_back({i, j});
      }
    }
  }
  return pairs;
}

void print(const char* name, const PlacedMesh& placed) {
  std::fprintf(stderr, "%s, pose by columns:", name);
  for (int i = 0; i < 16; ++i)
    std::fprintf(stderr, " %a", placed.pose.data()[i]);
  for (const Eigen::Vector3d& v : placed.mesh.vertices())
    std::fprintf(stderr, "\n  %a %a %a", v.x(), v.y(), v.z());
  std::fputc('\n', stderr);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes shapes(data, size);
  const Mesh mesh_a = small_mesh(shapes);
  const Mesh mesh_b = small_mesh(shapes);
  const Pose pose_a = shapes.pose();
  const Pose pose_b = shapes.pose();
  const PlacedMesh a{mesh_a, pose_a};
  const PlacedMesh b{mesh_b, pose_b};
  try {
    check_placement(pose_a, mesh_a.bounds(), "A");
    check_placement(pose_b, mesh_b.bounds(), "B");
  } catch (const PoseError&) {
    return 0;  // law 10 refuses it
  }
  const std::vector<TrianglePair> truth = true_pairs(a, b);
  for (const PairVolume volume : kPairVolumes) {
    if (find_triangle_pairs(a, b, {.volume = volume}).pairs == truth) continue;
    std::fprintf(stderr, "wrong with %s\n", name_of(volume));
    print("A", a);
    print("B", b);
    std::abort();
  }
  return 0;
}
