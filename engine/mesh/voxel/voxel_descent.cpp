#include <graze/bvh/traverse/traverse_cut.h>
#include <graze/engine/mesh/voxel/voxel_descent.h>
#include <graze/narrowphase/ray/axis_line.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>

#include <algorithm>

namespace graze {
namespace {

using narrowphase::LineCrossing;

/// The deepest descent: blocks are halved along three axes of at most 2^16 voxels.
constexpr std::size_t kMaxDepth = 3 * 16 + 1;

float longest_side(const bvh::FloatBox& box) {
  return std::max({box.max[0] - box.min[0], box.max[1] - box.min[1], box.max[2] - box.min[2]});
}

}  // namespace

void VoxelDescent::split(const VoxelTask& task, std::uint64_t task_size,
                         std::vector<VoxelTask>& tasks) {
  task_size_ = task_size;
  tasks_ = &tasks;
  levels_.resize(kMaxDepth);
  descend({task.block, task.is_corner_enclosed}, task.candidates, 0);
}

void VoxelDescent::run(const VoxelTask& task) {
  task_size_ = 0;
  levels_.resize(kMaxDepth);
  descend({task.block, task.is_corner_enclosed}, task.candidates, 0);
}

void VoxelDescent::descend(const Part& part, const VoxelCandidates& candidates, std::size_t depth) {
  const VoxelBlock& block = part.block;
  if (candidates.empty()) {
    if (part.is_corner_enclosed) add(block);
    return;
  }
  if (block.size() == 1) {
    if (part.is_corner_enclosed || is_touched(block, candidates)) add(block);
    return;
  }
  if (block.size() <= task_size_) {
    tasks_->push_back({block, candidates, part.is_corner_enclosed});
    return;
  }
  const int axis = block.longest_axis();
  const std::uint32_t middle = block.first[axis] + block.length(axis) / 2;
  Part lower = part;
  Part upper = part;
  lower.block.last[axis] = middle;
  upper.block.first[axis] = middle;
  if (scene_.fill == VoxelFill::Solid) {
    upper.is_corner_enclosed ^= is_odd_between_corners(block, upper.block, axis, candidates);
  }
  visit(lower, candidates, depth);
  visit(upper, candidates, depth);
}

/// Visits a block. A voxel is tested against what is left of the block above it: choosing first
/// would be as dear.
void VoxelDescent::visit(const Part& part, const VoxelCandidates& candidates_above,
                         std::size_t depth) {
  if (part.block.size() == 1) return descend(part, candidates_above, depth);
  VoxelCandidates& kept = levels_[depth];
  keep_touching(part.block, candidates_above, kept);
  descend(part, kept, depth + 1);
}

void VoxelDescent::keep_touching(const VoxelBlock& block, const VoxelCandidates& above,
                                 VoxelCandidates& kept) {
  kept.nodes.clear();
  kept.triangles.clear();
  const Aabb box = scene_.planes.box(block);
  const bvh::FloatBox local = scene_.planes.local_box(block);
  const float size = longest_side(local);
  const std::vector<bvh::Node>& nodes = scene_.tree.nodes;

  const auto keep_triangle = [&](std::uint32_t triangle) {
    ++work_.triangle_tests;
    if (narrowphase::triage(scene_.mesh.triangle(triangle), box) == narrowphase::Verdict::No) {
      return;
    }
    kept.triangles.push_back(triangle);
  };
  const auto is_apart = [&](std::uint32_t index) {
    ++work_.volume_tests;
    const bool is_pruned = !bvh::overlap(nodes[index].box, local);
    work_.volume_rejections += is_pruned;
    return is_pruned;
  };
  const auto is_small = [&](std::uint32_t index) { return longest_side(nodes[index].box) <= size; };
  const auto keep_node = [&](std::uint32_t index) {
    if (is_small(index)) {
      kept.nodes.push_back(index);
      return bvh::Walk::Continue;
    }
    const bvh::Node& leaf = nodes[index];
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
      keep_triangle(scene_.tree.primitives[i]);
    return bvh::Walk::Continue;
  };
  for (const std::uint32_t triangle : above.triangles)
    keep_triangle(triangle);
  bvh::traverse_cut(scene_.tree, above.nodes, is_apart, is_small, keep_node);
}

bool VoxelDescent::is_touched(const VoxelBlock& voxel, const VoxelCandidates& candidates) {
  const Aabb box = scene_.planes.box(voxel);
  const bvh::FloatBox local = scene_.planes.local_box(voxel);
  const std::vector<bvh::Node>& nodes = scene_.tree.nodes;

  const auto touches = [&](std::uint32_t triangle) {
    ++work_.triangle_tests;
    const narrowphase::Decision decision = narrowphase::decide(scene_.mesh.triangle(triangle), box);
    work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
    return decision.is_hit;
  };
  const auto is_apart = [&](std::uint32_t index) {
    ++work_.volume_tests;
    const bool is_pruned = !bvh::overlap(nodes[index].box, local);
    work_.volume_rejections += is_pruned;
    return is_pruned;
  };
  const auto test_leaf = [&](std::uint32_t index) {
    const bvh::Node& leaf = nodes[index];
    const auto first = scene_.tree.primitives.begin() + leaf.first;
    return std::any_of(first, first + leaf.count, touches) ? bvh::Walk::Stop : bvh::Walk::Continue;
  };
  const auto is_never_fine = [](std::uint32_t) { return false; };
  return std::any_of(candidates.triangles.begin(), candidates.triangles.end(), touches) ||
         bvh::traverse_cut(scene_.tree, candidates.nodes, is_apart, is_never_fine, test_leaf) ==
             bvh::Walk::Stop;
}

/// True if the number of crossings between the first corners of a block and of its upper half along
/// the axis, both moved, is odd.
bool VoxelDescent::is_odd_between_corners(const VoxelBlock& block, const VoxelBlock& upper,
                                          int axis, const VoxelCandidates& candidates) {
  const Eigen::Vector3d from = scene_.planes.first_corner(block);
  const Eigen::Vector3d to = scene_.planes.first_corner(upper);
  const bvh::FloatBox segment_box =
      bvh::merged(scene_.planes.local_first_corner(block), scene_.planes.local_first_corner(upper));
  const std::vector<bvh::Node>& nodes = scene_.tree.nodes;
  bool is_odd = false;
  for (const std::uint32_t triangle : candidates.triangles)
    is_odd ^= is_crossed(triangle, from, to, axis);

  const auto is_apart = [&](std::uint32_t index) {
    ++work_.volume_tests;
    const bool is_pruned = !bvh::overlap(nodes[index].box, segment_box);
    work_.volume_rejections += is_pruned;
    return is_pruned;
  };
  const auto count_leaf = [&](std::uint32_t index) {
    const bvh::Node& leaf = nodes[index];
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
      is_odd ^= is_crossed(scene_.tree.primitives[i], from, to, axis);
    return bvh::Walk::Continue;
  };
  const auto is_never_fine = [](std::uint32_t) { return false; };
  bvh::traverse_cut(scene_.tree, candidates.nodes, is_apart, is_never_fine, count_leaf);
  return is_odd;
}

bool VoxelDescent::is_crossed(std::uint32_t triangle, const Eigen::Vector3d& from,
                              const Eigen::Vector3d& to, int axis) {
  const Triangle corners = scene_.mesh.triangle(triangle);
  return narrowphase::cross_axis_line(corners, from.data(), axis) == LineCrossing::Above &&
         narrowphase::cross_axis_line(corners, to.data(), axis) == LineCrossing::Below;
}

void VoxelDescent::add(const VoxelBlock& block) {
  for (std::uint32_t k = block.first[2]; k < block.last[2]; ++k) {
    for (std::uint32_t j = block.first[1]; j < block.last[1]; ++j)
      runs_.emplace_back(block.first[0], j, k, block.length(0));
  }
}

}  // namespace graze
