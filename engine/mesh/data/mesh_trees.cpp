#include <graze/bvh/build/build_references.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/refit/refit_references.h>
#include <graze/bvh/skins/fit_skins.h>
#include <graze/bvh/value/to_local.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/work.h>
#include <tbb/task_arena.h>

namespace graze {
namespace {

/// Computes the local box of a triangle.
class TriangleBoxes {
 public:
  TriangleBoxes(std::span<const Eigen::Vector3d> vertices,
                std::span<const TriangleIndices> triangles, const bvh::LocalFrame& frame)
      : vertices_(vertices), triangles_(triangles), to_local_(frame) {}

  bvh::Bounds operator()(std::size_t i) const {
    const TriangleIndices& t = triangles_[i];
    return to_local_.box(vertices_[t[0]].data(), vertices_[t[1]].data(), vertices_[t[2]].data());
  }

 private:
  std::span<const Eigen::Vector3d> vertices_;
  std::span<const TriangleIndices> triangles_;
  bvh::ToLocal to_local_;
};

bvh::Tree tree_over(std::span<const Eigen::Vector3d> vertices,
                    std::span<const TriangleIndices> triangles, const Aabb& bounds) {
  const auto frame = bvh::LocalFrame::around(bounds);
  return bvh::build(
      bvh::references_made(triangles.size(), TriangleBoxes(vertices, triangles, frame)), frame);
}

/// Returns the older tree over the same triangles where they are now.
AgedTree refitted(const AgedTree& older, std::span<const Eigen::Vector3d> vertices,
                  std::span<const TriangleIndices> triangles, const Aabb& bounds, Work* work) {
  AgedTree aged = older;
  if (aged.costs.empty())
    aged.costs = bvh::subtree_costs(aged.tree, bvh::BuildSettings{}.primitive_cost);
  const auto frame = bvh::LocalFrame::around(bounds);
  bvh::References references =
      bvh::references_made(std::span<const std::uint32_t>(aged.tree.primitives),
                           TriangleBoxes(vertices, triangles, frame));
  const std::size_t rebuilt =
      bvh::refit_and_rebuild(aged.tree, aged.costs, references.all(), frame);
  if (work != nullptr) work->triangles_rebuilt += rebuilt;
  return aged;
}

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

std::shared_ptr<const AgedTree> Mesh::Data::tree_to_inherit() const {
  // The order matters: once the older tree has been given up, the mesh's own is there.
  std::shared_ptr<const AgedTree> older = older_tree.get();
  return is_tree_made.load(std::memory_order_acquire) ? tree : older;
}

const bvh::Tree& tree_of(const Mesh& mesh, Work* work) {
  const auto& data = MeshAccess::data(mesh);
  std::call_once(data.tree_flag, [&] {
    bvh::in_standard_arithmetic([&] {
      // The task is isolated, because a thread that waits for the parallel build would otherwise
      // take up any task, such as another query on this mesh, which would wait for the flag that
      // this thread holds.
      const std::shared_ptr<const AgedTree> older = data.older_tree.get();
      tbb::this_task_arena::isolate([&] {
        data.tree = std::make_shared<const AgedTree>(
            older != nullptr ? refitted(*older, data.vertices, data.triangles, data.bounds, work)
                             : AgedTree{tree_over(data.vertices, data.triangles, data.bounds), {}});
      });
      data.is_tree_made.store(true, std::memory_order_release);
      data.older_tree.set(nullptr);
      if (work != nullptr) ++(older != nullptr ? work->trees_refitted : work->trees_built);
    });
  });
  return data.tree->tree;
}

std::shared_ptr<const bvh::WideStock> Mesh::Data::wide_to_inherit() const {
  // The order matters: once the older tree has been given up, the mesh's own is there.
  std::shared_ptr<const bvh::WideStock> older = older_wide.get();
  if (!is_wide_made.load(std::memory_order_acquire)) return older;
  return std::make_shared<const bvh::WideStock>(wide->stock());
}

const bvh::WideTree& wide_tree_of(const Mesh& mesh, Work* work) {
  const auto& data = MeshAccess::data(mesh);
  // Each query asks here first: call_once() takes longer to say that there is nothing to do.
  if (data.is_wide_made.load(std::memory_order_acquire)) return *data.wide;
  std::call_once(data.wide_flag, [&] {
    bvh::in_standard_arithmetic([&] {
      data.corners = std::make_unique<bvh::CornerSource>(data.vertices, data.triangles);
      const std::shared_ptr<const bvh::WideStock> older = data.older_wide.get();
      // The task is isolated, as the building of the tree is.
      tbb::this_task_arena::isolate([&] {
        data.wide = older != nullptr
                        ? std::make_unique<bvh::WideTree>(data.bounds, *data.corners, *older)
                        : std::make_unique<bvh::WideTree>(data.bounds, *data.corners);
      });
      data.is_wide_made.store(true, std::memory_order_release);
      data.older_wide.set(nullptr);
      if (work != nullptr) ++(older != nullptr ? work->trees_refitted : work->trees_built);
    });
  });
  return *data.wide;
}

bool has_tree(const Mesh& mesh) {
  const auto& data = MeshAccess::data(mesh);
  return data.is_wide_made.load(std::memory_order_acquire) ||
         data.is_tree_made.load(std::memory_order_acquire);
}

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
