#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/work.h>
#include <tbb/task_arena.h>

namespace graze {

std::shared_ptr<const bvh::WideStock> Mesh::Data::wide_to_inherit() const {
  // In this order: once it has been given up, the mesh's own is there.
  std::shared_ptr<const bvh::WideStock> older = older_wide.get();
  if (!is_wide_made.load(std::memory_order_acquire)) return older;
  return std::make_shared<const bvh::WideStock>(wide->stock());
}

const bvh::WideTree& wide_tree_of(const Mesh& mesh, Work* work) {
  const auto& data = MeshAccess::data(mesh);
  // Each query asks: call_once() takes longer to say that there is nothing to do.
  if (data.is_wide_made.load(std::memory_order_acquire)) return *data.wide;
  std::call_once(data.wide_flag, [&] {
    bvh::in_standard_arithmetic([&] {
      data.corners = std::make_unique<bvh::CornerSource>(data.vertices, data.triangles);
      const std::shared_ptr<const bvh::WideStock> older = data.older_wide.get();
      // Isolated, as the building of the tree is.
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

}  // namespace graze
