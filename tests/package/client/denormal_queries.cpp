#include <graze/graze.h>

#include <vector>

#include "digest.h"
#include "numbers.h"
#include "queries.h"

namespace client {
namespace {

constexpr int kExponent = -1073;

/// Closed: tetrahedra with corners on a small lattice.
graze::Mesh random_mesh(Random& random, int tetrahedra) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<graze::TriangleIndices> triangles;
  for (int i = 0; i < tetrahedra; ++i) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (int k = 0; k < 4; ++k)
      vertices.push_back(random.point(5, kExponent));
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 3, first + 1});
    triangles.push_back({first + 1, first + 3, first + 2});
    triangles.push_back({first, first + 2, first + 3});
  }
  return graze::Mesh(vertices, triangles);
}

void add(Digest& digest, const Eigen::Vector3d& point) {
  for (int i = 0; i < 3; ++i)
    digest.add(point.data()[i]);
}

void add(Digest& digest, const graze::TrianglePairs& pairs) {
  for (const graze::TrianglePair& pair : pairs)
    digest.add(std::uint64_t{pair.a} << 32 | pair.b);
}

void ask_pair(Random& random, Answers& answers, Digest& digest) {
  const graze::Mesh a = random_mesh(random, 3), b = random_mesh(random, 3);
  graze::Pose pose = random.integer(1) == 0 ? rotation(random.next()) : graze::Pose::Identity();
  pose.translation() = random.point(5, kExponent);
  const bool is_hit = graze::intersects({a}, {b, pose});
  digest.add(std::uint64_t{is_hit});
  add(digest, graze::find_triangle_pairs({a}, {b, pose}));
  add(digest, graze::find_triangle_pairs({a}, {b, pose}, {.threads = 0}));
  const graze::MeshDistance gap = graze::distance({a}, {b, pose});
  digest.add(gap.distance), add(digest, gap.point_a), add(digest, gap.point_b);
  std::vector<graze::Pose> poses(40, pose);
  for (graze::Pose& each : poses)
    each.translation() = random.point(5, kExponent);
  for (const graze::TrianglePairs& pairs :
       graze::find_triangle_pairs({a}, graze::MeshInPoses(b, poses)))
    add(digest, pairs);
  const graze::Voxels voxels = graze::find_voxels(a, {.resolution = 4});
  digest.add(voxels.grid.edge), digest.add(std::uint64_t{voxels.size()});
  digest.add(std::uint64_t{graze::contains(a, random.point(5, kExponent))});
  answers.queries += 7;
  answers.hits += is_hit;
}

void ask_boxes(Random& random, Answers& answers, Digest& digest) {
  graze::BroadPhase boxes({.threads = 2});
  const auto box = [&] {
    const Eigen::Vector3d corner = random.point(50, kExponent);
    return graze::Aabb{corner, corner};
  };
  std::vector<graze::BoxId> ids;
  std::vector<graze::Aabb> places;
  for (int i = 0; i < 9000; ++i) {
    ids.push_back(boxes.add(box()));
    places.push_back(box());
  }
  boxes.update();
  answers.hits += boxes.pairs().size();
  boxes.move(ids, places);
  boxes.update();
  for (const graze::BoxPair& pair : boxes.sorted_pairs())
    digest.add(std::uint64_t{pair.a} << 32 | pair.b);
  ++answers.queries;
}

}  // namespace

Answers query_denormal() {
  Random random;
  Answers answers;
  Digest digest;
  for (int n = 0; n < 100; ++n)
    ask_pair(random, answers, digest);
  ask_boxes(random, answers, digest);
  answers.digest = digest.value();
  return answers;
}

}  // namespace client
