#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/rays/ray_groups.h>
#include <graze/bvh/rays/ray_tree.h>
#include <graze/bvh/value/parallel.h>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <vector>

namespace graze::bvh {
namespace {

// Below it all is one step: the exponents of floats end there, and 2^-100 is far less than what
// the walk grows boxes by.
constexpr int kLeastExponent = -100;

/// The smallest power of two of which 255 reach that far.
double step_for(double extent) {
  const double wanted = extent / 255;
  int exponent = wanted > 0 ? std::max(std::ilogb(wanted), kLeastExponent) : kLeastExponent;
  while (std::ldexp(255.0, exponent) < extent)
    ++exponent;
  return std::ldexp(1.0, exponent);
}

/// A wide node whose children's lines are not known yet.
RayNode node_over(const Tree& tree, const RayGroups& groups,
                  const std::uint32_t (&children)[RayNode::kWidth], std::uint32_t count) {
  FloatBox around = empty_box();
  for (std::uint32_t i = 0; i < count; ++i)
    around = merged(around, tree.nodes[children[i]].box);
  RayNode node{};
  node.child_count = static_cast<std::uint8_t>(count);
  for (int k = 0; k < 3; ++k) {
    const double origin = around.min[k];
    const double step = step_for(around.max[k] - origin);
    node.origin[k] = around.min[k];
    node.scale[k] = static_cast<float>(step);
    for (std::uint32_t i = 0; i < count; ++i) {
      const FloatBox& box = tree.nodes[children[i]].box;
      node.box[k][i] = static_cast<std::uint8_t>(std::floor((box.min[k] - origin) / step));
      node.box[k + 3][i] =
          static_cast<std::uint8_t>(std::min(255.0, std::ceil((box.max[k] - origin) / step)));
    }
  }
  std::uint32_t in_leaves = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!groups.is_leaf(children[i])) continue;
    node.child[i] = groups.first(children[i]);
    node.in_leaf[i] = static_cast<std::uint8_t>(groups.count(children[i]));
    node.before[i] = static_cast<std::uint8_t>(in_leaves);
    in_leaves += groups.count(children[i]);
  }
  return node;
}

std::uint32_t primitives_at(const RayNode& node) {
  std::uint32_t count = 0;
  for (const std::uint8_t in_leaf : node.in_leaf)
    count += in_leaf;
  return count;
}

/// All nodes, each before what is below it, and where they are.
struct Laid {
  std::vector<RayNode> nodes;
  std::vector<std::uint32_t> line;
  std::uint32_t line_count = 0;
  std::uint32_t depth = 0;

  void add(const RayNode& node) {
    nodes.push_back(node);
    line.push_back(line_count);
    const std::size_t bytes = sizeof(RayNode) + std::size_t{12} * primitives_at(node);
    line_count +=
        static_cast<std::uint32_t>((bytes + sizeof(RayTree::Line) - 1) / sizeof(RayTree::Line));
  }
};

Laid lay_out(const Tree& tree, const RayGroups& groups) {
  struct Waiting {
    std::uint32_t binary;
    std::size_t parent;
    std::uint32_t lane;
    std::uint32_t depth;
  };
  Laid laid;
  RayNode in_front{};
  in_front.child_count = 1;
  laid.add(in_front);
  std::vector<Waiting> waiting{{0, 0, 0, 1}};
  while (!waiting.empty()) {
    const Waiting at = waiting.back();
    waiting.pop_back();
    laid.depth = std::max(laid.depth, at.depth);
    std::uint32_t children[RayNode::kWidth];
    const std::uint32_t count = groups.children(at.binary, children);
    const std::size_t index = laid.nodes.size();
    laid.nodes[at.parent].child[at.lane] = laid.line_count;
    laid.add(node_over(tree, groups, children, count));
    for (std::uint32_t lane = count; lane-- > 0;) {
      if (!groups.is_leaf(children[lane]))
        waiting.push_back({children[lane], index, lane, at.depth + 1});
    }
  }
  return laid;
}

/// Puts the corners of the leaf in lane `lane` on its grid.
void fill_leaf(const RayNode& node, std::uint32_t lane, const Tree& tree,
               const LocalCorners& corners, std::uint32_t* to) {
  double low[3], per_unit[3];
  for (int k = 0; k < 3; ++k) {
    const double scale = node.scale[k];
    low[k] = node.origin[k] + scale * node.box[k][lane];
    const double extent = scale * (node.box[k + 3][lane] - node.box[k][lane]);
    per_unit[k] = extent > 0 ? RayTree::kSteps / extent : 0;
  }
  const std::uint32_t count = node.in_leaf[lane];
  for (std::uint32_t i = 0; i < count; ++i) {
    double corner[3][3];
    corners.of(tree.primitives[node.child[lane] + i], corner);
    for (std::uint32_t c = 0; c < 3; ++c) {
      std::uint32_t packed = 0;
      for (int k = 2; k >= 0; --k) {
        const double at = std::nearbyint((corner[c][k] - low[k]) * per_unit[k]);
        const double kept = std::clamp(at, 0.0, static_cast<double>(RayTree::kSteps));
        packed = packed << RayTree::kBits | static_cast<std::uint32_t>(kept);
      }
      to[c * count + i] = packed;
    }
  }
}

/// Writes the node and its leaves.
void write(const RayNode& node, const Tree& tree, const LocalCorners& corners, RayTree::Line* to) {
  std::memcpy(to, &node, sizeof(node));
  std::uint32_t packed[3 * RayNode::kWidth * RayTree::kLeafSize];
  for (std::uint32_t lane = 0; lane < node.child_count; ++lane) {
    if (node.in_leaf[lane] != 0)
      fill_leaf(node, lane, tree, corners, packed + std::size_t{3} * node.before[lane]);
  }
  const std::size_t size = std::size_t{3} * primitives_at(node) * sizeof(std::uint32_t);
  std::memcpy(to + sizeof(node) / sizeof(RayTree::Line), packed, size);
}

// A walk reads here and there: in pages of 4 KiB it would miss their table as often as the cache.
constexpr std::align_val_t kLargePage{std::size_t{1} << 21};
constexpr std::size_t kWorthLargePages = std::size_t{1} << 23;

std::unique_ptr<RayTree::Line[], RayTree::LargePages> lines_in_large_pages(std::size_t count) {
  const std::size_t bytes = count * sizeof(RayTree::Line);
  void* memory = ::operator new(bytes, kLargePage);
#ifdef __linux__
  // Where it is refused the pages are small.
  if (bytes >= kWorthLargePages) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
#endif
  return std::unique_ptr<RayTree::Line[], RayTree::LargePages>(new (memory) RayTree::Line[count]);
}

}  // namespace

void RayTree::LargePages::operator()(Line* made) const {
  ::operator delete(made, kLargePage);
}

RayTree ray_tree_over(const Tree& tree, const LocalCorners& corners) {
  const Laid laid = lay_out(tree, RayGroups(tree, RayTree::kLeafSize));
  RayTree rays;
  rays.frame = tree.frame;
  for (std::size_t k = 0; k < 4; ++k) {
    rays.low[k] = k < 3 ? tree.root().box.min[k] : 0;
    rays.high[k] = k < 3 ? tree.root().box.max[k] : 0;
  }
  rays.primitives = tree.primitives.data();
  // Each node on a way down leaves all of its children but one.
  rays.most_open = (RayNode::kWidth - 1) * laid.depth + 1;
  rays.line_count = std::size_t{laid.line_count} + 1;
  rays.lines = lines_in_large_pages(rays.line_count);
  std::memset(rays.lines.get() + laid.line_count, 0, sizeof(RayTree::Line));
  for_in_parallel(std::size_t{0}, laid.nodes.size(), [&](std::size_t i) {
    in_standard_arithmetic(
        [&] { write(laid.nodes[i], tree, corners, rays.lines.get() + laid.line[i]); });
  });
  return rays;
}

}  // namespace graze::bvh
