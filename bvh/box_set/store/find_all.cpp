// Searches for all pairs, and moves of all boxes: the parts of the box set that share their work
// among threads.

#include <graze/bvh/box_set/store/box_set.h>

#include <algorithm>

namespace graze::bvh {
namespace {

constexpr std::size_t kTasks = 512;  // at least so many, where there are enough blocks
constexpr std::size_t kChunks = 64;  // of tasks, each with a list of its own
constexpr std::size_t kBlocksPerTask = 512;
constexpr std::uint32_t kTreeBits = 8;
constexpr std::size_t kAhead = 32;  // boxes that are fetched before they are needed

int level_of(const BlockPair& pair) {
  return std::max(pair.level_a, pair.level_b);
}

}  // namespace

/// The search as pairs of blocks, in an order that no number of threads changes.
void BoxSet::list_tasks(std::size_t wanted) {
  std::vector<BlockPair>& tasks = scratch_.tasks;
  tasks.clear();
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    for (std::size_t j = i; j < layers_.size(); ++j) {
      if (layers_[i].block_count == 0 || layers_[j].block_count == 0) continue;
      tasks.push_back({0, 0, static_cast<std::uint8_t>(layers_[i].top - 1),
                       static_cast<std::uint8_t>(layers_[j].top - 1),
                       static_cast<std::uint16_t>(i << kTreeBits | j)});
    }
  }
  // Those of the highest level first: what lies below a task grows with its level.
  while (tasks.size() < wanted) {
    int highest = 0;
    for (const BlockPair& task : tasks)
      highest = std::max(highest, level_of(task));
    if (highest == 0) break;
    scratch_.next_tasks.clear();
    for (const BlockPair& task : tasks) {
      if (level_of(task) < highest) {
        scratch_.next_tasks.push_back(task);
      } else {
        split_pair(view(task.trees >> kTreeBits), view(task.trees & ((1 << kTreeBits) - 1)), task,
                   scratch_.next_tasks);
      }
    }
    tasks.swap(scratch_.next_tasks);
  }
}

/// Searches all of `tasks`, those of the same two trees together. Returns the pairs of blocks met.
std::uint64_t BoxSet::find_below(std::span<const BlockPair> tasks, PairBuffer& out) const {
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

void BoxSet::find_in_parallel(PairBuffer& out) {
  const std::vector<BlockPair>& tasks = scratch_.tasks;
  scratch_.found.resize(kChunks);
  scratch_.met.assign(kChunks, 0);
  workers_.for_each(kChunks, [&](std::size_t chunk) {
    PairBuffer& found = scratch_.found[chunk];
    found.clear();
    const std::size_t first = chunk * tasks.size() / kChunks;
    const std::size_t last = (chunk + 1) * tasks.size() / kChunks;
    scratch_.met[chunk] = find_below(std::span(tasks).subspan(first, last - first), found);
  });
  std::size_t starts[kChunks + 1] = {};
  for (std::size_t chunk = 0; chunk < kChunks; ++chunk) {
    starts[chunk + 1] = starts[chunk] + scratch_.found[chunk].size();
    met_ += scratch_.met[chunk];
  }
  out.resize(starts[kChunks]);
  workers_.for_each(kChunks, [&](std::size_t chunk) {
    const PairBuffer& found = scratch_.found[chunk];
    std::copy_n(found.data(), found.size(), out.data() + starts[chunk]);
  });
}

void BoxSet::find_all_pairs(PairBuffer& out) {
  out.clear();
  met_ = 0;
  list_tasks(kTasks);
  if (!workers_.share(size_)) {
    met_ = find_below(scratch_.tasks, out);
  } else {
    find_in_parallel(out);
  }
  if (met_sorted_ == 0 && sorts_ != 0) met_sorted_ = met_;
  if (met_ > met_sorted_) excess_ += static_cast<double>(met_ - met_sorted_);
}

/// Writes blocks one after the other, each with the boxes that `input_of` its places names.
template <typename InputOf>
void BoxSet::fill_blocks(std::span<const Aabb> boxes, const InputOf& input_of) {
  const std::size_t blocks = high_.size();
  workers_.for_each((blocks + kBlocksPerTask - 1) / kBlocksPerTask, [&](std::size_t chunk) {
    const std::size_t first = chunk * kBlocksPerTask * kLanes;
    const std::size_t last = std::min(first + kBlocksPerTask * kLanes, blocks * kLanes);
    for (std::size_t place = first; place < last; ++place) {
      // The boxes come in an order of their own: without this every one is waited for.
      const std::size_t later = input_of(std::min(place + kAhead, last - 1));
      if (later < boxes.size()) {
        __builtin_prefetch(boxes[later].min.data());
        __builtin_prefetch(boxes[later].max.data() + 2);
      }
      const std::size_t i = input_of(place);
      if (i >= boxes.size()) continue;
      const std::size_t block = place >> kLaneBits;
      set_lane(high_[block], low_[block], place & (kLanes - 1), ordered_box(boxes[i]));
    }
  });
  all_touched_ = true;
}

void BoxSet::move_named(std::span<const Aabb> boxes) {
  fill_blocks(boxes, [&](std::size_t place) {
    if (!scratch_.is_named[place]) return boxes.size();
    return std::size_t{low_[place >> kLaneBits].row[0][place & (kLanes - 1)]};
  });
}

void BoxSet::move_ranked(std::span<const Aabb> boxes) {
  fill_blocks(boxes, [&](std::size_t place) { return scratch_.ranked.rank(proxy_[place]); });
}

void BoxSet::move_first(std::span<const Aabb> boxes) {
  fill_blocks(boxes, [&](std::size_t place) { return proxy_[place]; });
}

}  // namespace graze::bvh
