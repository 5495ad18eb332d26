#include <graze/bvh/error.h>
#include <graze/engine/mesh/contacts/last_contact.h>
#include <graze/engine/mesh/contacts/swept_nodes.h>
#include <graze/engine/mesh/contacts/swept_triangles.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace graze::contacts {
namespace {

/// Two nodes, and no less than how far B can go until nothing in them meets any more.
struct OpenPair {
  double bound;
  std::uint32_t a;
  std::uint32_t b;
};

/// The pair of nodes that can meet latest is opened first. So no pair is opened whose bound is
/// below the answer: no order opens fewer. Bounds beyond the translation that is enough are cut to
/// it; of equals the one with the higher nodes, which stand further down the trees, is first.
class LatestFirst {
 public:
  LatestFirst(const bvh::Tree& tree_a, const bvh::Tree& tree_b, const SweptNodes& nodes,
              double enough, Work& work)
      : tree_a_(tree_a), tree_b_(tree_b), nodes_(nodes), enough_(enough), work_(work) {
    open_.reserve(256);
    note(0, 0);
  }

  /// `sweep_leaves(a, b)` raises `latest()`.
  template <typename SweepLeaves>
  void run(const SweepLeaves& sweep_leaves) {
    while (!open_.empty() && latest_ < enough_) {
      std::pop_heap(open_.begin(), open_.end(), is_sooner);
      const OpenPair pair = open_.back();
      open_.pop_back();
      if (pair.bound <= latest_) return;
      const bvh::Node& a = tree_a_.nodes[pair.a];
      const bvh::Node& b = tree_b_.nodes[pair.b];
      if (a.is_leaf() && b.is_leaf()) {
        sweep_leaves(a, b);
      } else if (b.is_leaf() || (!a.is_leaf() && nodes_.is_first_larger(a.box, b.box))) {
        note(a.first, pair.b);
        note(a.first + 1, pair.b);
      } else {
        note(pair.a, b.first);
        note(pair.a, b.first + 1);
      }
    }
  }

  double latest() const { return latest_; }
  void raise_latest(double translation) { latest_ = std::max(latest_, translation); }

 private:
  /// Total, so that no heap's ways show.
  static bool is_sooner(const OpenPair& p, const OpenPair& q) {
    if (p.bound != q.bound) return p.bound < q.bound;
    const std::uint64_t depth_p = std::uint64_t{p.a} + p.b;
    const std::uint64_t depth_q = std::uint64_t{q.a} + q.b;
    return depth_p != depth_q ? depth_p < depth_q : p.a < q.a;
  }

  void note(std::uint32_t a, std::uint32_t b) {
    ++work_.volume_tests;
    const double bound =
        nodes_.last_contact(tree_a_.nodes[a].box, tree_b_.nodes[b].box, latest_);
    if (bound <= latest_) {
      ++work_.volume_rejections;
      return;
    }
    open_.push_back({std::min(bound, enough_), a, b});
    std::push_heap(open_.begin(), open_.end(), is_sooner);
  }

  const bvh::Tree& tree_a_;
  const bvh::Tree& tree_b_;
  const SweptNodes& nodes_;
  double enough_;
  double latest_ = 0;
  Work& work_;
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

double last_contact(const PlacedMesh& a, const PlacedMesh& b, const Eigen::Vector3d& direction,
                    double limit, Work& work) {
  const bvh::Tree& tree_a = a.mesh.tree(&work);
  const bvh::Tree& tree_b = b.mesh.tree(&work);
  const SweepUnits units(a, b);
  const double d[3] = {direction.data()[0], direction.data()[1], direction.data()[2]};
  const SweptNodes nodes(a, b, units, d);
  LatestFirst search(tree_a, tree_b, nodes, limit * units.per_metre, work);
  search.run([&](const bvh::Node& leaf_a, const bvh::Node& leaf_b) {
    for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
      const SweptTriangle swept_a(place(a.pose, a.mesh.triangle(tree_a.primitives[i])),
                                  units.per_metre);
      for (std::uint32_t j = leaf_b.first; j < leaf_b.first + leaf_b.count; ++j) {
        const SweptTriangle swept_b(place(b.pose, b.mesh.triangle(tree_b.primitives[j])),
                                    units.per_metre);
        ++work.triangle_tests;
        search.raise_latest(last_contact(swept_a, swept_b, d, search.latest()));
      }
    }
  });
  return search.latest() * units.metres;
}

}  // namespace graze::contacts
