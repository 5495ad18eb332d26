#include <graze/bvh/error.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/sweep/last_contact.h>
#include <graze/engine/mesh/sweep/swept_nodes.h>
#include <graze/engine/mesh/sweep/swept_triangles.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace graze::contacts {
namespace {

/// A tree as far as a sweep has gone into it: each node's extent, and a leaf's triangles, are found
/// once, not for every node of the other tree that it is tried against.
class OpenedTree {
 public:
  struct Node {
    const bvh::Node* node;
    double size;
    std::uint32_t children;   ///< the first of two; 0 while they are not asked for
    std::uint32_t triangles;  ///< the first one of a leaf's, and 1; 0 while they are not asked for
    SweptNodes::Extent extent;
  };
  enum class Side { A, B };

  OpenedTree(Side side, const PlacedMeshView& placed, const SweptNodes& swept,
             const SweepUnits& units, Work& work)
      : side_(side),
        placed_(placed),
        tree_(tree_of(placed.mesh, &work)),
        swept_(swept),
        per_metre_(units.per_metre) {
    nodes_.reserve(128);
    add(tree_.nodes[0]);
  }

  const Node& operator[](std::uint32_t at) const { return nodes_[at]; }

  /// Returns the first of both children, which stand side by side. References to nodes end.
  std::uint32_t children(std::uint32_t at) {
    if (nodes_[at].children == 0) {
      nodes_[at].children = static_cast<std::uint32_t>(nodes_.size());
      const std::uint32_t first = nodes_[at].node->first;
      add(tree_.nodes[first]);
      add(tree_.nodes[first + 1]);
    }
    return nodes_[at].children;
  }

  std::span<const SweptTriangle> triangles(std::uint32_t at) {
    Node& leaf = nodes_[at];
    const bvh::Node& node = *leaf.node;
    if (leaf.triangles == 0) {
      leaf.triangles = static_cast<std::uint32_t>(triangles_.size()) + 1;
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Triangle triangle = placed_.mesh.triangle(tree_.primitives[i]);
        triangles_.emplace_back(narrowphase::place(placed_.pose, triangle), per_metre_);
      }
    }
    return {triangles_.data() + (leaf.triangles - 1), node.count};
  }

 private:
  void add(const bvh::Node& node) {
    const bool is_a = side_ == Side::A;
    nodes_.push_back({&node, is_a ? swept_.size_a(node.box) : swept_.size_b(node.box), 0, 0,
                      is_a ? swept_.extent_a(node.box) : swept_.extent_b(node.box)});
  }

  Side side_;
  const PlacedMeshView& placed_;
  const bvh::Tree& tree_;
  const SweptNodes& swept_;
  double per_metre_;
  std::vector<Node> nodes_;
  std::vector<SweptTriangle> triangles_;
};

/// Opens the pair of nodes first that can meet latest. So no pair is opened whose bound is below
/// the answer: no order opens fewer. Bounds beyond the translation that is enough are cut to it; of
/// equals the one that was found last goes first, to come to the triangles soon.
class LatestFirst {
 public:
  LatestFirst(OpenedTree& a, OpenedTree& b, const SweptNodes& swept, double enough, Work& work)
      : a_(a), b_(b), swept_(swept), enough_(enough), work_(work) {
    open_.reserve(256);
    note(0, 0);
  }

  /// Runs until the answer is found; `sweep_leaves(a, b)` raises `latest()`.
  template <typename SweepLeaves>
  void run(const SweepLeaves& sweep_leaves) {
    while (!open_.empty() && latest_ < enough_) {
      std::pop_heap(open_.begin(), open_.end(), is_sooner);
      const OpenPair pair = open_.back();
      open_.pop_back();
      if (pair.bound <= latest_) return;
      const bool is_leaf_a = a_[pair.a].node->is_leaf();
      const bool is_leaf_b = b_[pair.b].node->is_leaf();
      if (is_leaf_a && is_leaf_b) {
        sweep_leaves(pair.a, pair.b);
      } else if (is_leaf_b || (!is_leaf_a && a_[pair.a].size >= b_[pair.b].size)) {
        const std::uint32_t child = a_.children(pair.a);
        note(child, pair.b);
        note(child + 1, pair.b);
      } else {
        const std::uint32_t child = b_.children(pair.b);
        note(pair.a, child);
        note(pair.a, child + 1);
      }
    }
  }

  double latest() const { return latest_; }
  void raise_latest(double translation) { latest_ = std::max(latest_, translation); }

 private:
  /// Two nodes, and a bound that is no less than how far B can go until nothing in them meets any
  /// more.
  struct OpenPair {
    double bound;
    std::uint32_t number;  ///< the order of finding, which is total, so that no heap's own ways
                           ///< show
    std::uint32_t a;
    std::uint32_t b;
  };

  static bool is_sooner(const OpenPair& p, const OpenPair& q) {
    return p.bound != q.bound ? p.bound < q.bound : p.number < q.number;
  }

  void note(std::uint32_t a, std::uint32_t b) {
    ++work_.volume_tests;
    const double bound = swept_.last_contact(a_[a].extent, b_[b].extent, latest_);
    if (bound <= latest_) {
      ++work_.volume_rejections;
      return;
    }
    open_.push_back({std::min(bound, enough_), ++found_, a, b});
    std::push_heap(open_.begin(), open_.end(), is_sooner);
  }

  OpenedTree& a_;
  OpenedTree& b_;
  const SweptNodes& swept_;
  double enough_;
  double latest_ = 0;
  Work& work_;
  std::uint32_t found_ = 0;
  std::vector<OpenPair> open_;
};

}  // namespace

Eigen::Vector3d unit_direction(const Eigen::Vector3d& direction) {
  const double* d = direction.data();
  const double largest = std::max(std::abs(d[0]), std::max(std::abs(d[1]), std::abs(d[2])));
  if (!std::isfinite(d[0]) || !std::isfinite(d[1]) || !std::isfinite(d[2])) {
    throw InputError("direction: a component is not finite");
  }
  if (largest == 0) throw InputError("direction: it is zero");
  const int exponent = -std::ilogb(largest);
  const double x = std::scalbn(d[0], exponent);
  const double y = std::scalbn(d[1], exponent);
  const double z = std::scalbn(d[2], exponent);
  const double length = std::sqrt((x * x + y * y) + z * z);
  return {x / length, y / length, z / length};
}

double last_contact(const PlacedMeshView& a, const PlacedMeshView& b,
                    const Eigen::Vector3d& direction, double limit, Work& work) {
  const SweepUnits units(a, b);
  const double d[3] = {direction.data()[0], direction.data()[1], direction.data()[2]};
  tree_of(a.mesh, &work), tree_of(b.mesh, &work);
  const SweptNodes swept(a, b, units, d);
  OpenedTree opened_a(OpenedTree::Side::A, a, swept, units, work);
  OpenedTree opened_b(OpenedTree::Side::B, b, swept, units, work);
  LatestFirst search(opened_a, opened_b, swept, limit * units.per_metre, work);
  search.run([&](std::uint32_t leaf_a, std::uint32_t leaf_b) {
    for (const SweptTriangle& of_a : opened_a.triangles(leaf_a)) {
      for (const SweptTriangle& of_b : opened_b.triangles(leaf_b)) {
        ++work.triangle_tests;
        search.raise_latest(last_contact(of_a, of_b, d, search.latest()));
      }
    }
  });
  return search.latest() * units.metres;
}

}  // namespace graze::contacts
