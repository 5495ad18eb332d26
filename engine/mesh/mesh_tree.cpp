#include <graze/bvh/build.h>
#include <graze/engine/mesh/mesh_data.h>
#include <graze/engine/work.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace graze {
namespace {

std::vector<Aabb> triangle_boxes(std::span<const Eigen::Vector3d> vertices,
                                 std::span<const TriangleIndices> triangles) {
  std::vector<Aabb> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const double* a = vertices[triangles[i][0]].data();
    const double* b = vertices[triangles[i][1]].data();
    const double* c = vertices[triangles[i][2]].data();
    for (int k = 0; k < 3; ++k) {
      boxes[i].min.data()[k] = std::min(std::min(a[k], b[k]), c[k]);
      boxes[i].max.data()[k] = std::max(std::max(a[k], b[k]), c[k]);
    }
  }
  return boxes;
}

}  // namespace

const bvh::Tree& Mesh::tree(Work* work) const {
  std::call_once(data_->tree_flag, [&] {
    // Isolated, because a thread that waits for the parallel build would otherwise take up any
    // task, such as another query on this mesh, which would wait for the flag that this thread
    // holds.
    tbb::this_task_arena::isolate(
        [&] { data_->tree = bvh::build(triangle_boxes(data_->vertices, data_->triangles)); });
    if (work != nullptr) ++work->trees_built;
  });
  return data_->tree;
}

}  // namespace graze
