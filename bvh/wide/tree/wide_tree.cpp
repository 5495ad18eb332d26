#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/parallel.h>
#include <graze/bvh/wide/tree/treelet_build.h>
#include <graze/bvh/wide/tree/treelet_refit.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace graze::bvh {

WideTree::WideTree(const Aabb& bounds, const CornerSource& source)
    : frame_(LocalFrame::around(bounds)), box_(frame_.to_local(bounds)), source_(source) {
  set_top(split_all(source, frame_, primitives_));
}

WideTree::WideTree(const Aabb& bounds, const CornerSource& source, const WideStock& stock)
    : frame_(LocalFrame::around(bounds)),
      box_(frame_.to_local(bounds)),
      source_(source),
      primitives_(stock.primitives) {
  set_top(refitted(stock.top, source, frame_, primitives_));
}

void WideTree::set_top(WideTop top) {
  treelet_count_ = top.parts.size() + 1;
  treelets_ = std::make_unique<LazyTreelet[]>(treelet_count_);
  const auto above = std::make_shared<Treelet>();
  above->nodes = top_nodes(top.nodes, box_);
  treelets_[0].owned = above;
  treelets_[0].built = above.get();
  for (std::size_t i = 0; i < top.parts.size(); ++i) {
    treelets_[i + 1].part = top.parts[i];
    treelets_[i + 1].inherited = std::move(top.inherited[i]);
  }
  top_ = std::move(top);
}

// This is not inline: kernels are not instrumented in sanitized builds, and ThreadSanitizer does
// not see what a thread acquires there.
const Treelet& WideTree::entered(std::uint32_t index, TreeletCounts& counts) const {
  const Treelet* built = treelets_[index].built.load(std::memory_order_acquire);
  return built != nullptr ? *built : build(index, counts);
}

const Treelet& WideTree::build(std::uint32_t index, TreeletCounts& counts) const {
  LazyTreelet& lazy = treelets_[index];
  std::call_once(lazy.flag, [&] {
    // Nobody else writes to these places: only here are they read without the mutex.
    const auto places = primitives_.begin() + lazy.part.first;
    std::vector<std::uint32_t> order(places, places + lazy.part.count);
    std::optional<Treelet> refitted;
    if (lazy.inherited != nullptr)
      refitted = refitted_treelet(*lazy.inherited, lazy.part, order, frame_, source_);
    counts.refitted += refitted.has_value();
    counts.built += !refitted.has_value();
    auto treelet = std::make_shared<const Treelet>(
        refitted ? *std::move(refitted) : built_treelet(lazy.part, order, frame_, source_));
    const std::scoped_lock lock(mutex_);
    std::copy(order.begin(), order.end(), places);
    lazy.owned = std::move(treelet);
    lazy.inherited.reset();
    lazy.built.store(lazy.owned.get(), std::memory_order_release);
  });
  return treelet(index);
}

WideStock WideTree::stock() const {
  WideStock stock{top_, {}};
  const std::scoped_lock lock(mutex_);
  stock.primitives = primitives_;
  for (std::size_t i = 0; i < top_.parts.size(); ++i) {
    const LazyTreelet& lazy = treelets_[i + 1];
    stock.top.inherited[i] = lazy.owned != nullptr ? lazy.owned : lazy.inherited;
  }
  return stock;
}

TreeletCounts WideTree::build_all() const {
  std::atomic<std::uint64_t> built = 0;
  std::atomic<std::uint64_t> refitted = 0;
  for_in_parallel(std::size_t{1}, treelet_count_, [&](std::size_t i) {
    in_standard_arithmetic([&] {
      TreeletCounts one;
      entered(static_cast<std::uint32_t>(i), one);
      built += one.built;
      refitted += one.refitted;
    });
  });
  return {built, refitted};
}

std::size_t WideTree::bytes() const {
  std::size_t bytes = primitives_.size() * sizeof(std::uint32_t);
  for (std::uint32_t i = 0; i < treelet_count_; ++i) {
    bytes += sizeof(LazyTreelet);
    if (!is_built(i)) continue;
    bytes += treelet(i).nodes.size() * sizeof(WideNode) + treelet(i).corners.size() * sizeof(float);
  }
  return bytes;
}

}  // namespace graze::bvh
