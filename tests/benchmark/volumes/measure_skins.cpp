#include "tests/benchmark/volumes/measure_skins.h"

#include <graze/bvh/tree/statistics.h>
#include <graze/engine/mesh/data/mesh_trees.h>

#include <algorithm>
#include <span>

#include "tests/benchmark/common/stopwatch.h"

namespace graze::benchmark {
namespace {

/// Another mesh of the same triangles, which has built nothing yet.
Mesh unbuilt(const Mesh& mesh) {
  return Mesh(mesh.vertices(), mesh.triangles());
}

/// The median time of `build(mesh)` on meshes that have a tree, if `prepare` asks for it.
template <typename Prepare, typename Build>
double build_milliseconds(const Mesh& mesh, int repetitions, const Prepare& prepare,
                          const Build& build) {
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const Mesh fresh = unbuilt(mesh);
    prepare(fresh);
    const Stopwatch watch;
    build(fresh);
    times.push_back(watch.microseconds() / 1000);
  }
  return median(times);
}

template <typename Skin>
SkinMeasure measured(Volume volume, const Mesh& mesh, int repetitions, const Skin& skin_of) {
  const auto skin = skin_of(mesh);
  return {volume,
          build_milliseconds(
              mesh, repetitions, [](const Mesh& m) { tree_of(m); }, skin_of),
          skin.size_bytes(), bvh::volumes_by_level(tree_of(mesh), skin)};
}

}  // namespace

std::vector<SkinMeasure> measure_skins(const Mesh& mesh, int repetitions) {
  std::vector<SkinMeasure> skins;
  skins.push_back({Volume::Aabb,
                   build_milliseconds(
                       mesh, repetitions, [](const Mesh&) {}, [](const Mesh& m) { tree_of(m); }),
                   bvh::statistics_of(tree_of(mesh)).bytes, bvh::volumes_by_level(tree_of(mesh))});
  skins.push_back(
      measured(Volume::Sphere, mesh, repetitions, [](const Mesh& m) { return sphere_skin_of(m); }));
  skins.push_back(
      measured(Volume::Obb, mesh, repetitions, [](const Mesh& m) { return obb_skin_of(m); }));
  skins.push_back(
      measured(Volume::KDop, mesh, repetitions, [](const Mesh& m) { return kdop_skin_of(m); }));
  return skins;
}

}  // namespace graze::benchmark
