#include <graze/bvh/boxes.h>
#include <graze/bvh/build.h>
#include <graze/bvh/sah_split.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

namespace graze::bvh {
namespace {

/// Below this many primitives a subtree is built by one task.
constexpr std::size_t kParallelSize = 4096;

/// From this depth on ranges are halved by count, whatever the heuristic says.
constexpr int kMaxHeuristicDepth = 64;

/// Builds into slots that depend on the input alone. An inner node is the only one that splits the
/// order at position m, so that its children may take the slots 2m - 1 and 2m without asking
/// anyone: tasks need no lock and their number changes nothing. Leaves of several primitives leave
/// holes, which compacted() closes.
class Builder {
 public:
  Builder(std::span<Reference> references, const BuildSettings& settings)
      : references_(references), settings_(settings), slots_(2 * references.size() - 1) {}

  std::vector<Node> run() {
    tbb::task_group tasks;
    build_range(0, 0, references_.size(), 0, tasks);
    tasks.wait();
    return compacted();
  }

 private:
  void build_range(std::size_t slot, std::size_t begin, std::size_t end, int depth,
                   tbb::task_group& tasks) {
    const std::span<Reference> range = references_.subspan(begin, end - begin);
    Node& node = slots_[slot];
    node.box = bounds_of(range);
    const std::size_t split = split_position(range, node.box, depth);
    if (split == 0) {
      node.first = static_cast<std::uint32_t>(begin);
      node.count = static_cast<std::uint32_t>(end - begin);
      return;
    }
    const std::size_t middle = begin + split;
    const std::size_t children = 2 * middle - 1;
    node.first = static_cast<std::uint32_t>(children);
    node.count = 0;
    if (end - begin >= kParallelSize) {
      tasks.run([=, this, &tasks] { build_range(children, begin, middle, depth + 1, tasks); });
    } else {
      build_range(children, begin, middle, depth + 1, tasks);
    }
    build_range(children + 1, middle, end, depth + 1, tasks);
  }

  /// Partitions the range and returns the size of its first part, or 0 for a leaf.
  std::size_t split_position(std::span<Reference> range, const FloatBox& box, int depth) const {
    if (range.size() == 1) return 0;
    if (depth < kMaxHeuristicDepth) {
      const Split split = find_sah_split(range, box);
      const float leaf_cost = settings_.primitive_cost * static_cast<float>(range.size());
      const float split_cost = 1 + settings_.primitive_cost * split.cost;
      const bool is_leaf_allowed = range.size() <= settings_.max_leaf_size;
      if (is_leaf_allowed && !(split.axis >= 0 && split_cost < leaf_cost)) return 0;
      if (split.axis >= 0) return partition_at(range, split);
    }
    return range.size() <= settings_.max_leaf_size ? 0 : partition_in_halves(range);
  }

  /// The nodes without holes, depth first, the children of a node side by side behind it.
  std::vector<Node> compacted() const {
    std::vector<Node> nodes{slots_[0]};
    nodes.reserve(slots_.size());
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const std::uint32_t parent = open.back();
      open.pop_back();
      if (nodes[parent].is_leaf()) continue;
      const std::uint32_t slot = nodes[parent].first;
      const auto children = static_cast<std::uint32_t>(nodes.size());
      nodes[parent].first = children;
      nodes.push_back(slots_[slot]);
      nodes.push_back(slots_[slot + 1]);
      open.push_back(children + 1);
      open.push_back(children);
    }
    nodes.shrink_to_fit();
    return nodes;
  }

  std::span<Reference> references_;
  BuildSettings settings_;
  std::vector<Node> slots_;
};

}  // namespace

Tree build(std::span<const Aabb> boxes, const BuildSettings& settings) {
  check_boxes(boxes);
  Tree tree;
  tree.frame = LocalFrame::around(bounds_of(boxes));
  std::vector<Reference> references(boxes.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, boxes.size(), kParallelSize),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          references[i] = {tree.frame.to_local(boxes[i]), static_cast<std::uint32_t>(i)};
        }
      });
  tree.nodes = Builder(references, settings).run();
  tree.primitives.reserve(references.size());
  for (const Reference& reference : references)
    tree.primitives.push_back(reference.index);
  return tree;
}

}  // namespace graze::bvh
