#include <graze/bvh/build/small_subtree.h>
#include <graze/bvh/build/split.h>
#include <graze/bvh/build/subtree.h>
#include <graze/bvh/tree/node_lanes.h>

namespace graze::bvh {
namespace {

class Builder {
 public:
  Builder(std::span<Reference> references, const Part& part, const BuildSettings& settings)
      : references_(references.subspan(part.begin, part.size())), settings_(settings) {
    // Wide trees need as many nodes as this; smaller leaves make more, and memory grows once.
    nodes_.reserve(part.size() / 4 * 3 + 1);
    nodes_.push_back(node_over(part.box, 0, 0));
    build(0, {0, part.size(), part.depth, part.box, part.centroids});
  }

  std::vector<Node> take() { return std::move(nodes_); }

 private:
  void build(std::size_t at, const Part& part) {
    if (part.size() > 1 && part.size() <= kSmallSubtree) {
      build_small_subtree(references_, part, settings_, at, nodes_);
      return;
    }
    Part sides[2];
    if (part.size() == 1 || split(references_, part, settings_, sides) == SplitResult::Leaf) {
      nodes_[at].first = static_cast<std::uint32_t>(part.begin);
      nodes_[at].count = static_cast<std::uint32_t>(part.size());
      return;
    }
    const std::size_t children = nodes_.size();
    nodes_[at].first = static_cast<std::uint32_t>(children);
    for (const Part& side : sides)
      nodes_.push_back(node_over(side.box, 0, 0));
    build(children, sides[0]);
    build(children + 1, sides[1]);
  }

  std::span<Reference> references_;
  BuildSettings settings_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<Node> build_subtree(std::span<Reference> references, const Part& part,
                                const BuildSettings& settings) {
  return Builder(references, part, settings).take();
}

}  // namespace graze::bvh
