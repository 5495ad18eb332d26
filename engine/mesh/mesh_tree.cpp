#include <graze/bvh/build_references.h>
#include <graze/bvh/to_local.h>
#include <graze/engine/mesh/mesh_data.h>
#include <graze/engine/work.h>
#include <tbb/task_arena.h>

namespace graze {
namespace {

bvh::Tree tree_over(std::span<const Eigen::Vector3d> vertices,
                    std::span<const TriangleIndices> triangles, const Aabb& bounds) {
  const auto frame = bvh::LocalFrame::around(bounds);
  const bvh::ToLocal to_local(frame);
  return bvh::build(bvh::references_made(triangles.size(),
                                         [&](std::size_t i) {
                                           const TriangleIndices& t = triangles[i];
                                           return to_local.box(vertices[t[0]].data(),
                                                               vertices[t[1]].data(),
                                                               vertices[t[2]].data());
                                         }),
                    frame);
}

}  // namespace

const bvh::Tree& Mesh::tree(Work* work) const {
  std::call_once(data_->tree_flag, [&] {
    // Isolated, because a thread that waits for the parallel build would otherwise take up any
    // task, such as another query on this mesh, which would wait for the flag that this thread
    // holds.
    tbb::this_task_arena::isolate(
        [&] { data_->tree = tree_over(data_->vertices, data_->triangles, data_->bounds); });
    if (work != nullptr) ++work->trees_built;
  });
  return data_->tree;
}

}  // namespace graze
