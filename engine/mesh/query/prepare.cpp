#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/engine/mesh/data/mesh_rays.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <tbb/task_arena.h>

namespace graze {

void prepare(const Mesh& mesh, const PrepareSettings& settings, Work* work) {
  bvh::in_standard_arithmetic([&] {
    const bvh::WideTree& tree = wide_tree_of(mesh, work);
    bvh::TreeletCounts counts;
    // The task is isolated: a thread that waits here must not take up a task of the caller's own
    // loop.
    tbb::this_task_arena::isolate([&] { counts = tree.build_all(); });
    if (work != nullptr) add_counts(counts, *work);
    if (settings.queries == PreparedFor::All) {
      tree_of(mesh, work);
      rays_of(mesh, work);
      kdop_skin_of(mesh, work);  // this is for casts of boxes and balls
    }
  });
}

}  // namespace graze
