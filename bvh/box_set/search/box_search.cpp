// This searches for all pairs; threads share the work.

#include <graze/bvh/box_set/search/box_search.h>

#include <algorithm>

namespace graze::bvh {
namespace {

constexpr std::size_t kTasks = 512;     // the least number of tasks, where there are enough blocks
constexpr std::size_t kChunks = 64;     // the number of chunks of tasks, each with a list of its
                                        // own
constexpr std::uint32_t kTreeBits = 8;  // the bits of BlockPair::trees for the number of one tree

int level_of(const BlockPair& pair) {
  return std::max(pair.level_a, pair.level_b);
}

}  // namespace

/// Lists the search as pairs of blocks, in an order that no number of threads changes.
void BoxSearch::list_tasks(std::size_t wanted) {
  std::vector<BlockPair>& tasks = tasks_;
  tasks.clear();
  for (std::size_t i = 0; i < store_.layers.size(); ++i) {
    for (std::size_t j = i; j < store_.layers.size(); ++j) {
      if (store_.layers[i].block_count == 0 || store_.layers[j].block_count == 0) continue;
      tasks.push_back({0, 0, static_cast<std::uint8_t>(store_.layers[i].top - 1),
                       static_cast<std::uint8_t>(store_.layers[j].top - 1),
                       static_cast<std::uint16_t>(i << kTreeBits | j)});
    }
  }
  // Tasks of the highest level are split first: what lies below a task grows with its level.
  while (tasks.size() < wanted) {
    int highest = 0;
    for (const BlockPair& task : tasks)
      highest = std::max(highest, level_of(task));
    if (highest == 0) break;
    next_tasks_.clear();
    for (const BlockPair& task : tasks) {
      if (level_of(task) < highest) {
        next_tasks_.push_back(task);
      } else {
        split_pair(view(task.trees >> kTreeBits), view(task.trees & ((1 << kTreeBits) - 1)), task,
                   next_tasks_);
      }
    }
    tasks.swap(next_tasks_);
  }
}

/// Searches all of `tasks`, those of the same two trees together. Returns how many pairs of blocks
/// it met.
std::uint64_t BoxSearch::find_below(std::span<const BlockPair> tasks, PairBuffer& out) const {
  std::uint64_t met = 0;
  for (std::size_t first = 0, last = 0; first < tasks.size(); first = last) {
    while (last < tasks.size() && tasks[last].trees == tasks[first].trees)
      ++last;
    met += find_pairs(view(tasks[first].trees >> kTreeBits),
                      view(tasks[first].trees & ((1 << kTreeBits) - 1)),
                      tasks.subspan(first, last - first), out);
  }
  return met;
}

std::uint64_t BoxSearch::find_in_parallel(PairBuffer& out) {
  const std::vector<BlockPair>& tasks = tasks_;
  found_of_.resize(kChunks);
  met_of_.assign(kChunks, 0);
  workers_.for_each(kChunks, [&](std::size_t chunk) {
    PairBuffer& found = found_of_[chunk];
    found.clear();
    const std::size_t first = chunk * tasks.size() / kChunks;
    const std::size_t last = (chunk + 1) * tasks.size() / kChunks;
    met_of_[chunk] = find_below(std::span(tasks).subspan(first, last - first), found);
  });
  std::uint64_t met = 0;
  std::size_t starts[kChunks + 1] = {};
  for (std::size_t chunk = 0; chunk < kChunks; ++chunk) {
    starts[chunk + 1] = starts[chunk] + found_of_[chunk].size();
    met += met_of_[chunk];
  }
  out.resize(starts[kChunks]);
  workers_.for_each(kChunks, [&](std::size_t chunk) {
    const PairBuffer& found = found_of_[chunk];
    std::copy_n(found.data(), found.size(), out.data() + starts[chunk]);
  });
  return met;
}

std::uint64_t BoxSearch::find_all_pairs(PairBuffer& out) {
  out.clear();
  list_tasks(kTasks);
  met_ = workers_.share(store_.size) ? find_in_parallel(out) : find_below(tasks_, out);
  return met_;
}

void BoxSearch::find_overlapping(const OrderedBox& box, std::vector<std::uint32_t>& out) const {
  for (std::uint32_t layer = 0; layer < store_.layers.size(); ++layer) {
    if (store_.layers[layer].block_count != 0) bvh::find_overlapping(view(layer), box, out);
  }
}

void BoxSearch::look_up_movers(std::span<const OrderedBox> before,
                               std::span<const OrderedBox> after, Lookup& lookup,
                               std::vector<MoverOverlap>& out) const {
  for (std::uint32_t layer = 0; layer < store_.layers.size(); ++layer) {
    if (store_.layers[layer].block_count != 0)
      bvh::find_overlapping_either(view(layer), before, after, lookup, out);
  }
}

void BoxSearch::walk_along(const RaySlabs& ray, double& limit, const RayVisitor& visit) const {
  for (std::uint32_t layer = 0; layer < store_.layers.size(); ++layer) {
    if (store_.layers[layer].block_count != 0) bvh::walk_along(view(layer), ray, limit, visit);
  }
}

std::size_t BoxSearch::bytes() const {
  std::size_t sum = 0;
  for (const PairBuffer& found : found_of_)
    sum += found.capacity() * sizeof(BoxPair);
  return sum;
}

}  // namespace graze::bvh
