#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/parallel.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/mesh/voxel/voxel_descent.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace graze {
namespace {

/// The number of blocks for threads to share: this many if the surface were everywhere, but none so
/// small that handing it over would show.
constexpr std::uint64_t kTaskCount = 16384;
constexpr std::uint64_t kMinTaskSize = 512;

/// Counts parts as they are done, one thread at a time.
class PartsDone {
 public:
  PartsDone(const VoxelSettings& settings, std::uint64_t users_control_word, std::size_t total)
      : settings_(settings), users_control_word_(users_control_word), total_(total) {}

  /// Adds a part with so many voxels. Throws InputError if they become too many.
  void add(std::uint64_t voxels) {
    const std::lock_guard lock(mutex_);
    voxels_ += voxels;
    // Other threads end what they are doing before they learn that one of them threw.
    if (is_over_) return;
    is_over_ = true;
    if (voxels_ > settings_.max_voxels) {
      throw InputError("resolution: " + std::to_string(settings_.resolution) + " gives more than " +
                       std::to_string(settings_.max_voxels) + " voxels");
    }
    ++done_;
    if (settings_.on_progress) {
      bvh::in_users_arithmetic(users_control_word_, [&] { settings_.on_progress(done_, total_); });
    }
    is_over_ = false;
  }

 private:
  const VoxelSettings& settings_;
  std::uint64_t users_control_word_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::uint64_t voxels_ = 0;
  bool is_over_ = false;  ///< whether one of the threads threw
  std::mutex mutex_;
};

std::uint64_t count_voxels(std::span<const VoxelRun> runs) {
  std::uint64_t count = 0;
  for (const VoxelRun& run : runs)
    count += run.length();
  return count;
}

/// Returns how many threads to ask for. More than oneTBB has are not asked for, or it would warn on
/// stderr.
int arena_size(const VoxelSettings& settings) {
  check_threads(settings.threads);
  if (settings.threads == 0) return tbb::task_arena::automatic;
  const std::size_t available =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(settings.threads, static_cast<int>(available));
}

/// Returns the mesh as it is placed. The identity changes no vertex.
Mesh mesh_in_place(const PlacedMeshView& placed) {
  check_placement(placed.pose, placed.mesh.bounds(), "pose of the mesh");
  if (placed.pose.matrix() == Eigen::Matrix4d::Identity()) return placed.mesh;
  std::vector<Eigen::Vector3d> vertices(placed.mesh.vertices().begin(),
                                        placed.mesh.vertices().end());
  for (Eigen::Vector3d& vertex : vertices)
    vertex = narrowphase::place(placed.pose, vertex);
  return placed.mesh.deformed(vertices);
}

VoxelTask whole_grid(const Mesh& mesh, const VoxelGrid& grid, VoxelFill fill, Work& work) {
  VoxelTask task;
  task.block = {{0, 0, 0}, grid.counts};
  task.candidates.nodes = {0};
  if (fill == VoxelFill::Solid) {
    task.is_corner_enclosed = is_moved_point_enclosed(mesh, grid.origin, work);
  }
  return task;
}

std::vector<VoxelRun> sorted_runs(const VoxelScene& scene, const VoxelTask& whole,
                                  const VoxelSettings& settings, std::uint64_t users_control_word,
                                  Work& work) {
  VoxelDescent top(scene);
  std::vector<VoxelTask> tasks;
  top.split(whole, std::max(whole.block.size() / kTaskCount, kMinTaskSize), tasks);

  tbb::enumerable_thread_specific<VoxelDescent> descents([&] { return VoxelDescent(scene); });
  PartsDone done(settings, users_control_word, tasks.size() + 1);
  done.add(count_voxels(top.runs()));
  bvh::for_in_parallel(tbb::blocked_range<std::size_t>(0, tasks.size(), 1),
                       [&](const tbb::blocked_range<std::size_t>& range) {
                         bvh::in_standard_arithmetic([&] {
                           VoxelDescent& descent = descents.local();
                           for (std::size_t i = range.begin(); i < range.end(); ++i) {
                             const std::size_t before = descent.runs().size();
                             descent.run(tasks[i]);
                             done.add(count_voxels(std::span(descent.runs()).subspan(before)));
                           }
                         });
                       });
  std::vector<VoxelRun> runs = std::move(top.runs());
  work += top.work();
  for (VoxelDescent& descent : descents) {
    runs.insert(runs.end(), descent.runs().begin(), descent.runs().end());
    descent.runs() = {};
    work += descent.work();
  }
  tbb::parallel_sort(runs.begin(), runs.end());
  return runs;
}

std::vector<Voxel> expanded(const std::vector<VoxelRun>& runs) {
  std::vector<Voxel> voxels;
  voxels.reserve(count_voxels(runs));
  for (const VoxelRun& run : runs) {
    Voxel voxel = run.first();
    for (std::uint32_t n = run.length(); n > 0; --n, ++voxel.i)
      voxels.push_back(voxel);
  }
  return voxels;
}

}  // namespace

Voxels find_voxels(const PlacedMeshView& placed, const VoxelSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> Voxels {
    const int threads = arena_size(settings);
    const Mesh mesh = mesh_in_place(placed);
    Voxels result{VoxelGrid::over(mesh.bounds(), settings.resolution), {}};
    if (settings.fill == VoxelFill::Solid) check_closed(mesh, "the mesh");
    CountedWork counted(work);
    const std::uint64_t users_control_word = bvh::users_control_word();
    tbb::task_arena(threads).execute([&] {
      // Another thread may run this.
      bvh::in_standard_arithmetic([&] {
        const bvh::Tree& tree = tree_of(mesh, &counted.work());
        const VoxelPlanes planes(result.grid, tree.frame, mesh.bounds());
        const VoxelTask whole = whole_grid(mesh, result.grid, settings.fill, counted.work());
        result.voxels = expanded(sorted_runs({mesh, tree, planes, settings.fill}, whole, settings,
                                             users_control_word, counted.work()));
      });
    });
    return result;
  });
}

}  // namespace graze
