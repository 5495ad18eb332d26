// Do two meshes touch? two_meshes A B [DZ]: B is moved by DZ metres along z.

#include <graze/graze.h>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr, "usage: two_meshes A B [DZ in metres]\n");
    return 2;
  }
  try {
    const graze::Mesh mesh_a = graze::load_mesh(argv[1]);
    const graze::Mesh mesh_b = graze::load_mesh(argv[2]);
    graze::Pose pose_b = graze::Pose::Identity();
    if (argc == 4) pose_b.translation().z() = std::strtod(argv[3], nullptr);

    const bool is_hit = graze::intersects({mesh_a}, {mesh_b, pose_b});
    const graze::TrianglePairs pairs = graze::find_triangle_pairs({mesh_a}, {mesh_b, pose_b});
    std::printf("%s: %zu pairs of triangles intersect\n", is_hit ? "hit" : "clear", pairs.size());
    if (!pairs.empty()) {
      std::printf("the first: triangle %u of A and triangle %u of B\n", pairs[0].a, pairs[0].b);
    }
  } catch (const graze::Error& error) {
    std::fprintf(stderr, "two_meshes: %s\n", error.what());
    return 1;
  }
}
