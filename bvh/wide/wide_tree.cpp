#include <graze/bvh/wide/treelet_build.h>
#include <graze/bvh/wide/wide_tree.h>
#include <tbb/parallel_for.h>

#include <numeric>

namespace graze::bvh {
namespace {

/// Primitives of a treelet at most: what a walk builds at once, a fraction of a millisecond.
constexpr std::size_t kTreeletSize = 2048;

}  // namespace

WideTree::WideTree(const Aabb& bounds, const CornerSource& source)
    : frame_(LocalFrame::around(bounds)),
      box_(frame_.to_local(bounds)),
      source_(source),
      primitives_(source.size()) {
  References references = source.references(frame_);
  const TopTree top = split_top(references.all(), kTreeletSize, kWideSettings);
  for (std::size_t i = 0; i < primitives_.size(); ++i)
    primitives_[i] = references.data[i].index();
  treelet_count_ = top.parts.size() + 1;
  treelets_ = std::make_unique<LazyTreelet[]>(treelet_count_);
  treelets_[0].treelet.nodes = top_nodes(top, box_);
  treelets_[0].is_built = true;
  for (std::size_t i = 0; i < top.parts.size(); ++i) {
    Treelet& treelet = treelets_[i + 1].treelet;
    treelet.first = static_cast<std::uint32_t>(top.parts[i].begin);
    treelet.count = static_cast<std::uint32_t>(top.parts[i].size());
    treelet.depth = top.parts[i].depth;
  }
}

// Not inline: kernels are not instrumented in sanitized builds, and what a thread acquires there
// ThreadSanitizer does not see.
const WideTree::Treelet& WideTree::entered(std::uint32_t index, std::uint64_t& built) const {
  const LazyTreelet& lazy = treelets_[index];
  if (!lazy.is_built.load(std::memory_order_acquire)) build(index, built);
  return lazy.treelet;
}

void WideTree::build(std::uint32_t index, std::uint64_t& built) const {
  const LazyTreelet& lazy = treelets_[index];
  std::call_once(lazy.flag, [&] {
    Treelet& treelet = lazy.treelet;
    build_treelet(treelet, std::span(primitives_).subspan(treelet.first, treelet.count), frame_,
                  source_);
    lazy.is_built.store(true, std::memory_order_release);
    ++built;
  });
}

std::size_t WideTree::build_all() const {
  std::atomic<std::size_t> built = 0;
  tbb::parallel_for(std::size_t{1}, treelet_count_, [&](std::size_t i) {
    std::uint64_t one = 0;
    if (!is_built(static_cast<std::uint32_t>(i))) build(static_cast<std::uint32_t>(i), one);
    built += one;
  });
  return built;
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
