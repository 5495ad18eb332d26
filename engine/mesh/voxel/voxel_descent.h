#pragma once

// This is how find_voxels() goes down from blocks of voxels to voxels. It is private to
// engine/mesh.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/voxel/voxel_planes.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/engine/work.h>

#include <cstdint>
#include <vector>

namespace graze {

/// The data that all blocks of one query share.
struct VoxelScene {
  const Mesh& mesh;
  const bvh::Tree& tree;
  const VoxelPlanes& planes;
  VoxelFill fill;
};

/// All parts of a mesh that can touch a block: whole nodes while they are smaller than it, and
/// triangles.
struct VoxelCandidates {
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint32_t> triangles;

  bool empty() const { return nodes.empty() && triangles.empty(); }
};

/// A block with all that is known of it.
struct VoxelTask {
  VoxelBlock block;
  VoxelCandidates candidates;
  /// If the mesh is a solid, whether the point beside the block's first corner, moved into the
  /// block as narrowphase/ray/axis_line.h says, is enclosed.
  bool is_corner_enclosed = false;
};

/// A run of voxels (i .. i + length - 1, j, k), packed so that numbers order as voxels do.
class VoxelRun {
 public:
  VoxelRun(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t length)
      : packed_(std::uint64_t{k} << 48 | std::uint64_t{j} << 32 | std::uint64_t{i} << 16 | length) {
  }

  std::uint32_t length() const { return packed_ & 0xffff; }
  Voxel first() const {
    return {static_cast<std::uint16_t>(packed_ >> 16), static_cast<std::uint16_t>(packed_ >> 32),
            static_cast<std::uint16_t>(packed_ >> 48)};
  }
  friend bool operator<(const VoxelRun& a, const VoxelRun& b) { return a.packed_ < b.packed_; }

 private:
  std::uint64_t packed_;
};

/// Halves blocks along their longest side, keeping for each what can touch it, down to voxels,
/// which an exact test decides, and to blocks that nothing touches, which are wholly inside or
/// outside.
///
/// Which of both they are is known from the block's first corner. Its parity is handed down: the
/// corner of an upper half lies on an edge of the whole block, so that between the two corners the
/// surface is crossed by the whole block's candidates alone.
class VoxelDescent {
 public:
  explicit VoxelDescent(const VoxelScene& scene) : scene_(scene) {}

  /// Halves blocks until they have at most `task_size` voxels, and appends them to `tasks`.
  void split(const VoxelTask& task, std::uint64_t task_size, std::vector<VoxelTask>& tasks);

  /// Goes all the way down from a block.
  void run(const VoxelTask& task);

  /// Returns the runs that were found, in no order.
  std::vector<VoxelRun>& runs() { return runs_; }
  const Work& work() const { return work_; }

 private:
  struct Part {
    VoxelBlock block;
    bool is_corner_enclosed;
  };

  void descend(const Part& part, const VoxelCandidates& candidates, std::size_t depth);
  void visit(const Part& part, const VoxelCandidates& candidates_above, std::size_t depth);
  void keep_touching(const VoxelBlock& block, const VoxelCandidates& above, VoxelCandidates& kept);
  bool is_touched(const VoxelBlock& voxel, const VoxelCandidates& candidates);
  bool is_odd_between_corners(const VoxelBlock& block, const VoxelBlock& upper, int axis,
                              const VoxelCandidates& candidates);
  bool is_crossed(std::uint32_t triangle, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  int axis);
  void add(const VoxelBlock& block);

  VoxelScene scene_;
  std::uint64_t task_size_ = 0;
  std::vector<VoxelTask>* tasks_ = nullptr;
  std::vector<VoxelCandidates> levels_;  ///< the candidates for each depth, reused by all blocks of
                                         ///< that depth
  std::vector<VoxelRun> runs_;
  Work work_;
};

}  // namespace graze
