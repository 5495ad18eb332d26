#include <graze/engine/mesh/placement.h>
#include <graze/graze.h>

#include <vector>

#include "digest.h"
#include "numbers.h"
#include "queries.h"

namespace client {
namespace {

struct Surface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<graze::TriangleIndices> triangles;

  /// Two triangles over each cell of a grid of points, which must be the last ones added.
  void join_grid(std::uint32_t columns, std::uint32_t rows) {
    const auto first = static_cast<std::uint32_t>(vertices.size()) - columns * rows;
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
      for (std::uint32_t column = 0; column + 1 < columns; ++column) {
        const std::uint32_t a = first + row * columns + column;
        triangles.push_back({a, a + 1, a + columns});
        triangles.push_back({a + 1, a + columns + 1, a + columns});
      }
    }
  }
};

/// Hills over [-1, 1]^2, with steps of 2^-4 and heights of multiples of 2^-7.
graze::Mesh make_terrain() {
  Random random;
  Surface surface;
  for (int y = -16; y <= 16; ++y) {
    for (int x = -16; x <= 16; ++x) {
      surface.vertices.emplace_back(std::ldexp(x, -4), std::ldexp(y, -4),
                                    std::ldexp(random.integer(9), -7));
    }
  }
  surface.join_grid(33, 33);
  return graze::Mesh(surface.vertices, surface.triangles);
}

/// The surface of [-1, 1]^3, eight cells to an edge: a closed mesh once welded.
graze::Mesh make_cube() {
  Surface surface;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side : {-1, 1}) {
      for (int v = -4; v <= 4; ++v) {
        for (int u = -4; u <= 4; ++u) {
          Eigen::Vector3d point;
          point[axis] = side;
          point[(axis + 1) % 3] = std::ldexp(u * side, -2);
          point[(axis + 2) % 3] = std::ldexp(v, -2);
          surface.vertices.push_back(point);
        }
      }
      surface.join_grid(9, 9);
    }
  }
  return graze::Mesh(surface.vertices, surface.triangles);
}

struct Scene {
  graze::Pose ground = graze::Pose::Identity();
  graze::Pose cube = graze::Pose::Identity();
};

/// The cube stands on the terrain's lattice, give or take ulps: as it is, or turned together with
/// the terrain, so that rounding decides what touches, or turned alone.
Scene nth_scene(Random& random, int n) {
  Scene scene;
  const Eigen::Vector3d spot = random.point(16, -3);
  const double height = std::ldexp(128 + random.integer(24), -7);
  scene.cube.translation() << spot.x(), spot.y(), moved_by_ulps(height, random.integer(2));
  if (n % 3 == 1) {
    scene.ground = rotation(random.next());
    const Eigen::Vector3d place = graze::place(scene.ground, scene.cube.translation());
    scene.cube = scene.ground;
    scene.cube.translation() = place;
  } else if (n % 3 == 2) {
    scene.cube.linear() = rotation(random.next()).linear();
  }
  return scene;
}

void add_pairs(Digest& digest, const graze::TrianglePairs& pairs) {
  for (const graze::TrianglePair& pair : pairs) {
    digest.add(std::uint64_t{pair.a} << 32 | pair.b);
  }
}

void add_triangles(Digest& digest, const graze::TriangleList& list) {
  for (std::uint32_t triangle : list)
    digest.add(std::uint64_t{triangle});
}

}  // namespace

Answers query_meshes() {
  Random random;
  Answers answers;
  Digest digest;
  const graze::Mesh terrain = make_terrain();
  const graze::Mesh cube = make_cube();
  for (int n = 0; n < 60; ++n) {
    const auto& [ground, pose] = nth_scene(random, n);
    const graze::TrianglePairs pairs = graze::find_triangle_pairs({terrain, ground}, {cube, pose});
    const bool is_hit = graze::intersects({terrain, ground}, {cube, pose});
    digest.add(std::uint64_t{is_hit});
    add_pairs(digest, pairs);
    add_triangles(digest, graze::find_triangles({terrain, ground}, graze::Obb{pose, {0.5, 1, 1}}));
    add_triangles(digest, graze::find_triangles({cube, pose}, terrain.bounds()));
    answers.queries += 4;
    answers.hits += is_hit;
  }
  add_pairs(digest, graze::find_self_pairs(cube));
  add_pairs(digest,
            graze::find_self_pairs(cube, {.kind = graze::SelfPairKind::Neighbour, .limit = 500}));
  digest.add(std::uint64_t{graze::self_intersects(terrain)});
  answers.queries += 3;
  answers.digest = digest.value();
  return answers;
}

namespace {

/// 1 for a value accepted, 2 for one refused as bad input, 3 for a bad pose, 4 for a bad mesh.
template <typename Query>
std::uint64_t outcome_of(Query query) {
  try {
    query();
    return 1;
  } catch (const graze::MeshError&) {
    return 4;
  } catch (const graze::PoseError&) {
    return 3;
  } catch (const graze::InputError&) {
    return 2;
  }
}

}  // namespace

Answers offer_bad_values() {
  // Read from memory: with -ffast-math the compiler may assume that no constant is one of these.
  static volatile std::uint64_t bits[] = {0x7ff8000000000000u, 0x7ff0000000000000u,
                                          0xfff0000000000000u};
  const graze::Mesh cube = make_cube();
  Answers answers;
  Digest digest;
  for (std::uint64_t word : bits) {
    const double bad = std::bit_cast<double>(word);
    graze::Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, bad}};
    graze::Pose pose = graze::Pose::Identity();
    pose.translation().x() = bad;
    const std::vector<Eigen::Vector3d> vertices = {triangle.a, triangle.b, triangle.c};
    const std::vector<graze::TriangleIndices> triangles = {{0, 1, 2}};
    for (std::uint64_t outcome : {
             outcome_of([&] { return graze::intersects(triangle, triangle); }),
             outcome_of([&] { return graze::intersects(triangle, cube.bounds()); }),
             outcome_of([&] {
               return graze::intersects({cube}, {cube, pose});
             }),
             outcome_of([&] { return graze::Mesh(vertices, triangles); }),
         }) {
      digest.add(outcome);
      answers.hits += outcome != 1;
      ++answers.queries;
    }
  }
  answers.digest = digest.value();
  return answers;
}

}  // namespace client
