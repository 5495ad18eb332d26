#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/skins/fit_skins.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/work.h>
#include <tbb/task_arena.h>

namespace graze {
namespace {

std::vector<Eigen::Vector3d> corners_of(std::span<const Eigen::Vector3d> vertices,
                                        std::span<const TriangleIndices> triangles) {
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(3 * triangles.size());
  for (const TriangleIndices& triangle : triangles) {
    for (const std::uint32_t index : triangle)
      corners.push_back(vertices[index]);
  }
  return corners;
}

/// Fits `skin.volumes` once, isolated as the building of the tree is.
template <typename Skin, typename Fit>
void fit_once(Skin& skin, const Mesh& mesh, Work* work, const Fit& fit) {
  const bvh::Tree& tree = tree_of(mesh, work);
  std::call_once(skin.flag, [&] {
    bvh::in_standard_arithmetic([&] {
      tbb::this_task_arena::isolate([&] {
        const bvh::Hulls hulls(tree, corners_of(mesh.vertices(), mesh.triangles()), 3);
        skin.volumes = fit(tree, hulls);
      });
      if (work != nullptr) ++work->skins_built;
    });
  });
}

}  // namespace

std::span<const bvh::FloatSphere> sphere_skin_of(const Mesh& mesh, Work* work) {
  const auto& data = MeshAccess::data(mesh);
  fit_once(data.spheres, mesh, work, bvh::fit_spheres);
  return data.spheres.volumes;
}

std::span<const bvh::FloatObb> obb_skin_of(const Mesh& mesh, Work* work) {
  const auto& data = MeshAccess::data(mesh);
  fit_once(data.obbs, mesh, work, bvh::fit_obbs);
  return data.obbs.volumes;
}

std::span<const bvh::FloatKDop> kdop_skin_of(const Mesh& mesh, Work* work) {
  const auto& data = MeshAccess::data(mesh);
  fit_once(data.kdops, mesh, work, bvh::fit_kdops);
  return data.kdops.volumes;
}

}  // namespace graze
