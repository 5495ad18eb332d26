// What a deformation costs beside building trees anew, and what queries cost afterwards beside
// those of fresh trees. Writes JSON.

#include <graze/bvh/error.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/prepare.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/shapes/random_meshes.h"

namespace graze::benchmark {
namespace {

using Vertices = std::vector<Eigen::Vector3d>;

constexpr int kRuns = 5;
constexpr int kPoses = 10;

struct Deformation {
  std::string name;
  Vertices vertices;
};

double size_of(const Mesh& mesh) {
  return (mesh.bounds().max - mesh.bounds().min).norm();
}

double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
    sum += (mesh.triangle(i).a - mesh.triangle(i).b).norm();
  return sum / static_cast<double>(mesh.triangles().size());
}

Vertices with_noise(const Mesh& mesh, double size) {
  RandomSource source(7);
  Vertices vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& p : vertices)
    p += source.vector(-size, size);
  return vertices;
}

/// Turned about the z axis by so many degrees from the lowest point to the highest.
Vertices twisted(const Mesh& mesh, double degrees) {
  const Aabb& box = mesh.bounds();
  const Eigen::Vector3d middle = 0.5 * (box.min + box.max);
  Vertices vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& p : vertices) {
    const double share = (p.z() - box.min.z()) / std::max(box.max.z() - box.min.z(), 1e-300);
    const double angle = degrees / 180 * 3.14159265358979 * share;
    const double x = p.x() - middle.x();
    const double y = p.y() - middle.y();
    p.x() = middle.x() + x * std::cos(angle) - y * std::sin(angle);
    p.y() = middle.y() + x * std::sin(angle) + y * std::cos(angle);
  }
  return vertices;
}

std::vector<Deformation> deformations_of(const Mesh& mesh) {
  return {{"none", with_noise(mesh, 0)},
          {"noise of 0.2 edges", with_noise(mesh, 0.2 * mean_edge(mesh))},
          {"noise of 1 edge", with_noise(mesh, mean_edge(mesh))},
          {"noise of 3% of the size", with_noise(mesh, 0.03 * size_of(mesh))},
          {"twist by 10 degrees", twisted(mesh, 10)},
          {"twist by 30 degrees", twisted(mesh, 30)},
          {"twist by 90 degrees", twisted(mesh, 90)},
          {"twist by 360 degrees", twisted(mesh, 360)}};
}

/// The least of what it takes, milliseconds.
template <typename Act>
void take_time(double& least, Act&& act) {
  const ThreadClock clock;
  act();
  least = std::min(least, clock.nanoseconds() * 1e-6);
}

struct Times {
  double wide = std::numeric_limits<double>::infinity();
  double binary = wide;
  double pairs = wide;
  double pairs_by_aabb = wide;
  double distances = wide;
};

void ask(const Mesh& mesh, const Mesh& other, Times& times) {
  RandomSource source(3);
  const double size = size_of(other);
  const Eigen::Vector3d middle = 0.5 * (other.bounds().min + other.bounds().max);
  std::vector<Pose> poses;
  for (int i = 0; i < kPoses; ++i) {
    Pose pose = tests::random_pose(0, source);
    pose.translation() = middle - pose.linear() * middle + source.vector(-0.3, 0.3) * size;
    poses.push_back(pose);
  }
  take_time(times.pairs, [&] {
    for (const Pose& pose : poses)
      find_triangle_pairs({mesh}, {other, pose});
  });
  take_time(times.pairs_by_aabb, [&] {
    for (const Pose& pose : poses)
      find_triangle_pairs({mesh}, {other, pose}, {.volume = PairVolume::Aabb});
  });
  take_time(times.distances, [&] {
    for (Pose pose : poses) {
      pose.translation().x() += 1.2 * size;
      distance({mesh}, {other, pose});
    }
  });
}

void measure(std::FILE* file, const Mesh& mesh, const Deformation& to, const char* separator) {
  const Mesh other(mesh.vertices(), mesh.triangles());
  prepare(other);
  tree_of(other);
  double deforming = std::numeric_limits<double>::infinity();
  Times refitted;
  Times built;
  Work work;
  for (int run = 0; run < kRuns; ++run) {
    work = {};
    Mesh moved = mesh;
    take_time(deforming, [&] { moved = mesh.deformed(to.vertices); });
    take_time(refitted.wide, [&] { prepare(moved, {}, &work); });
    take_time(refitted.binary, [&] { tree_of(moved, &work); });
    const Mesh fresh(to.vertices, mesh.triangles());
    take_time(built.wide, [&] { prepare(fresh); });
    take_time(built.binary, [&] { tree_of(fresh); });
    ask(moved, other, refitted);
    ask(fresh, other, built);
  }
  const auto pair = [&](const char* name, double of_refitted, double of_built) {
    std::fprintf(file, ", \"%s\": [%.4f, %.4f]", name, of_refitted, of_built);
  };
  std::fprintf(file, "%s\n   {\"deformation\": \"%s\", \"deformed_ms\": %.4f", separator,
               to.name.c_str(), deforming);
  pair("wide_ms", refitted.wide, built.wide);
  pair("binary_ms", refitted.binary, built.binary);
  pair("pairs_ms", refitted.pairs, built.pairs);
  pair("pairs_by_aabb_ms", refitted.pairs_by_aabb, built.pairs_by_aabb);
  pair("distances_ms", refitted.distances, built.distances);
  std::fprintf(file,
               ", \"treelets_refitted\": %llu, \"treelets_built\": %llu, "
               "\"triangles_rebuilt\": %llu}",
               static_cast<unsigned long long>(work.treelets_refitted),
               static_cast<unsigned long long>(work.treelets_built),
               static_cast<unsigned long long>(work.triangles_rebuilt));
}

void run(const std::string& output, const std::vector<std::string>& meshes) {
  std::FILE* file = std::fopen(output.c_str(), "w");
  if (file == nullptr) throw Error(output + ": cannot be written");
  std::fprintf(file, "{\"processor\": \"%s\", \"of each two\": [\"refitted\", \"built\"],\n",
               processor_name().c_str());
  std::fprintf(file, " \"meshes\": [");
  const char* separator = "";
  for (const std::string& name : meshes) {
    const Mesh mesh = load_mesh(name);
    prepare(mesh);
    tree_of(mesh);
    std::fprintf(file, "%s\n  {\"mesh\": \"%s\", \"triangles\": %zu, \"times\": [", separator,
                 std::filesystem::path(name).stem().c_str(), mesh.triangles().size());
    separator = "";
    for (const Deformation& deformation : deformations_of(mesh)) {
      measure(file, mesh, deformation, separator);
      separator = ",";
    }
    std::fprintf(file, "]}");
  }
  std::fprintf(file, "]}\n");
  if (std::fclose(file) != 0) throw Error(output + ": cannot be written");
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: graze_benchmark_deform OUTPUT.json MESH...\n", stderr);
    return 2;
  }
  // Times of one thread.
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  try {
    graze::benchmark::run(argv[1], {argv + 2, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_benchmark_deform: %s\n", error.what());
    return 2;
  }
}
