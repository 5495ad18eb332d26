// A walk over two wide trees. Included once for each SIMD target.

#if defined(GRAZE_BVH_PAIR_WALKER) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_PAIR_WALKER
#undef GRAZE_BVH_PAIR_WALKER
#else
#define GRAZE_BVH_PAIR_WALKER
#endif

#include <graze/bvh/wide/lanes/near_lanes-inl.h>
#include <graze/bvh/wide/lanes/pair_lanes-inl.h>
#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <graze/bvh/wide/lanes/slab_lanes-inl.h>
#include <graze/bvh/wide/walk/pair_batch-inl.h>
#include <graze/bvh/wide/walk/wide_pair_walk.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// One of eight query boxes.
struct QueryAmongOthers {
  const QueriesInNode& in_node;
  std::uint32_t lane;

  HWY_INLINE float axis(int k, int i) const { return in_node.axes[k][i]; }
  HWY_INLINE float size(int k, int i) const { return in_node.size[k][i]; }
  HWY_INLINE float cross_radius(int k, int i) const { return in_node.cross_radius[k][i][lane]; }
  HWY_INLINE float offset(int i) const { return in_node.offset[i][lane]; }
  HWY_INLINE float radius(int i) const { return in_node.radius[i][lane]; }
  HWY_INLINE float half(int k) const { return in_node.half[k][lane]; }
};

/// The bits of the children whose boxes are smaller than this.
HWY_INLINE std::uint32_t smaller_lanes(const WideNode& node, float size) {
  const Tag tag;
  std::uint32_t lanes = 0;
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    const Lanes sizes =
        hn::Add(hn::Add(hn::Load(tag, node.half[0] + lane), hn::Load(tag, node.half[1] + lane)),
                hn::Load(tag, node.half[2] + lane));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, hn::Lt(sizes, hn::Set(tag, size)), bits);
    lanes |= std::uint32_t{bits[0]} << lane;
  }
  return lanes;
}

/// More children than these near one box, and something is likely to be hit soon: a walk to any
/// pair then follows the nearest before it looks at the others. One to all pairs does not: which
/// boxes are near may differ between SIMD targets, and the order of its pairs must not.
constexpr int kMostAtATime = 3;

using Goal = WidePairWalk::Goal;

/// One walk, from where it stopped to where it has found enough.
template <Goal kGoal>
class Walker {
 public:
  Walker(WidePairWalk::State& state, std::span<FoundPair> found, WideWalkCounts& counts)
      : state_(state),
        found_(found),
        counts_(counts),
        scale_b_(static_cast<float>(state.into[0].scale)) {}

  /// All pairs that there is room for.
  std::size_t run() {
    while (!state_.open.empty()) {
      compare(state_.open.pop());
      if (size_ + pairs_.size() + WidePairWalk::kMostInStep <= found_.size()) continue;
      decide();
      if (size_ > 0) return size_;
    }
    decide();
    return size_;
  }

  /// What the first leaves have that are left with any.
  std::size_t run_to_any() {
    while (size_ == 0 && !state_.open.empty()) {
      look_elsewhere_in_time();
      compare(state_.open.pop());
    }
    return size_;
  }

 private:
  static constexpr bool kIsAny = kGoal == Goal::AnyPair;

  /// A walk to all pairs looks at all that a step began with, however many pairs that are.
  HWY_INLINE bool is_step_over() const { return kIsAny && size_ != 0; }

  HWY_INLINE void look_elsewhere_in_time() {
    if (--state_.steps_left > 0) return;
    state_.patience *= 2;
    state_.steps_left = state_.patience;
    state_.open.swap_ends();
  }

  HWY_INLINE void compare(const WidePairWalk::Waiting& pair) {
    const std::uint32_t link_a = pair.a.node->child[pair.a.lane];
    const std::uint32_t link_b = pair.b.node->child[pair.b.lane];
    if (kIsAny && ChildLink::is_leaf(link_a) && ChildLink::is_leaf(link_b)) {
      compare_waiting_leaves(pair.a, pair.b, link_b);
    } else if (is_first_opened(pair.a, link_a, pair.b, link_b, scale_b_)) {
      open_tested(0, pair.a, link_a, pair.b, link_b);
    } else {
      open_tested(1, pair.b, link_b, pair.a, link_a);
    }
  }

  /// Tests the children of one node against a query box. Those that are near, and leaves or smaller
  /// than that box, become query boxes in turn, against the children of the node that it bounds.
  HWY_INLINE void open_tested(int tested_side, const WideChildRef& tested,
                              std::uint32_t tested_link, const WideChildRef& query,
                              std::uint32_t query_link) {
    const TreeTransform& transform = state_.into[tested_side];
    set_query(query_, *query.node, query.lane, transform);
    const WideChildRef below =
        first_below(*state_.tree[tested_side], tested, tested_link, counts_.treelets);
    const WideNode& node = *below.node;
    set_query_in_node(in_node_, query_, node, transform.slack + kComparisonError * size_of(tested));
    std::uint32_t near = near_lanes(node, OneQuery{in_node_}, squared_distances_);
    if (near != 0 && node.has_slabs && query.node->has_slabs) {
      near &= near_slabs(
          node, OneQuery{in_node_},
          slab_of(*query.node, query.lane, static_cast<float>(transform.scale), in_node_.padding));
    }
    count(node, near);
    if (near == 0) return;
    if (ChildLink::is_leaf(query_link)) {
      push_or_compare(tested_side, below, near, squared_distances_, query, query_link);
      return;
    }
    const std::uint32_t next =
        near & (leaf_lanes(node) |
                smaller_lanes(node, size_of(query) * static_cast<float>(transform.scale)));
    for (std::uint32_t rest = near & ~next; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(rest));
      push(tested_side, {&node, lane, below.treelet}, query);
    }
    if (next != 0) open_query(1 - tested_side, query, query_link, tested, below, next);
  }

  /// The same with the roles exchanged, for several query boxes of one node at once; `above` is the
  /// box around all of these.
  HWY_INLINE void open_query(int tested_side, const WideChildRef& tested, std::uint32_t tested_link,
                             const WideChildRef& above, const WideChildRef& queries,
                             std::uint32_t lanes) {
    const TreeTransform& transform = state_.into[tested_side];
    const WideChildRef below =
        first_below(*state_.tree[tested_side], tested, tested_link, counts_.treelets);
    const WideNode& node = *below.node;
    const float sizes = size_of(tested) + 2 * size_of(above) * static_cast<float>(transform.scale);
    const float padding = transform.slack + kComparisonError * sizes;
    set_queries_in_node(queries_in_node_, *queries.node, node, transform, padding);
    const bool are_slabs_asked = node.has_slabs && queries.node->has_slabs;
    const bool are_many = kIsAny && std::popcount(lanes) > kMostAtATime;
    alignas(32) float squared_distances[WideNode::kWidth];
    while (lanes != 0 && !is_step_over()) {
      const std::uint32_t lane =
          are_many ? nearest(lanes, squared_distances_) : farthest(lanes, squared_distances_);
      lanes &= ~(1u << lane);
      const QueryAmongOthers other{queries_in_node_, lane};
      std::uint32_t near = near_lanes(node, other, squared_distances);
      if (near != 0 && are_slabs_asked) {
        near &=
            near_slabs(node, other,
                       slab_of(*queries.node, lane, static_cast<float>(transform.scale), padding));
      }
      count(node, near);
      if (are_many && near != 0) {
        push_all(1 - tested_side, queries, lanes, squared_distances_, tested);
        lanes = 0;
      }
      push_or_compare(tested_side, below, near, squared_distances,
                      {queries.node, lane, queries.treelet}, queries.node->child[lane]);
    }
    push_all(1 - tested_side, queries, lanes, squared_distances_, tested);
  }

  /// What of a tested node's children is near a query box: leaves are compared with leaves at once.
  /// Several children near one leaf are first tried against its primitives one by one: where these
  /// are large beside the children, much of the leaf's box is empty.
  HWY_INLINE void push_or_compare(int tested_side, const WideChildRef& below, std::uint32_t near,
                                  const float* squared_distances, const WideChildRef& query,
                                  std::uint32_t query_link) {
    const bool is_query_leaf = ChildLink::is_leaf(query_link);
    bool is_query_leaf_set = false;
    are_query_edges_set_ = false;
    if (is_query_leaf && std::popcount(near) > 1) {
      set_query_leaf(query_leaf_, state_.tree[1 - tested_side]->treelet(query.treelet), query_link,
                     state_.tree[tested_side]->treelet(below.treelet), state_.into[tested_side]);
      is_query_leaf_set = true;
      set_leaf_in_node(leaf_in_node_, query_leaf_, *below.node,
                       state_.tree[tested_side]->treelet(below.treelet).origin);
      near &= near_primitives_of(leaf_in_node_, ChildLink::count(query_link), *below.node);
    }
    if constexpr (kIsAny) {
      const std::uint32_t leaves = is_query_leaf ? near & leaf_lanes(*below.node) : 0;
      if (leaves != 0) {
        if (!is_query_leaf_set)
          set_query_leaf(query_leaf_, state_.tree[1 - tested_side]->treelet(query.treelet),
                         query_link, state_.tree[tested_side]->treelet(below.treelet),
                         state_.into[tested_side]);
        near ^= compare_nearest_leaves(tested_side, below, leaves, squared_distances, query,
                                       query_link);
      }
      push_all(tested_side, below, near, squared_distances, query);
      return;
    }
    while (near != 0) {
      const std::uint32_t lane = farthest(near, squared_distances);
      near &= ~(1u << lane);
      const std::uint32_t link = below.node->child[lane];
      if (is_query_leaf && ChildLink::is_leaf(link)) {
        const WideTree::Treelet& tested_treelet = state_.tree[tested_side]->treelet(below.treelet);
        const WideTree::Treelet& query_treelet =
            state_.tree[1 - tested_side]->treelet(query.treelet);
        if (!is_query_leaf_set)
          set_query_leaf(query_leaf_, query_treelet, query_link, tested_treelet,
                         state_.into[tested_side]);
        is_query_leaf_set = true;
        compare_leaves(tested_side, tested_treelet, {below.node, lane, below.treelet}, query,
                       query_link);
        continue;
      }
      push(tested_side, {below.node, lane, below.treelet}, query);
    }
  }

  /// Where any pair ends the walk: the nearest leaves first, until some are left with pairs.
  /// Returns those that have been compared.
  HWY_INLINE std::uint32_t compare_nearest_leaves(int tested_side, const WideChildRef& below,
                                                  std::uint32_t leaves,
                                                  const float* squared_distances,
                                                  const WideChildRef& query,
                                                  std::uint32_t query_link) {
    const WideTree::Treelet& tested = state_.tree[tested_side]->treelet(below.treelet);
    std::uint32_t rest = leaves;
    while (rest != 0 && size_ == 0) {
      const std::uint32_t lane = nearest(rest, squared_distances);
      rest &= ~(1u << lane);
      compare_leaves(tested_side, tested, {below.node, lane, below.treelet}, query, query_link);
      decide();
    }
    return leaves ^ rest;
  }

  /// Leaves that waited because others were left with pairs.
  HWY_NOINLINE void compare_waiting_leaves(const WideChildRef& leaf_a, const WideChildRef& leaf_b,
                                           std::uint32_t link_b) {
    const WideTree::Treelet& treelet_a = state_.tree[0]->treelet(leaf_a.treelet);
    set_query_leaf(query_leaf_, state_.tree[1]->treelet(leaf_b.treelet), link_b, treelet_a,
                   state_.into[0]);
    are_query_edges_set_ = false;
    compare_leaves(0, treelet_a, leaf_a, leaf_b, link_b);
    decide();
  }

  HWY_INLINE void push(int side, const WideChildRef& child, const WideChildRef& other) {
    state_.open.push(side == 0 ? WidePairWalk::Waiting{child, other}
                               : WidePairWalk::Waiting{other, child});
  }

  /// Children of one node, the nearest last.
  HWY_INLINE void push_all(int side, const WideChildRef& first, std::uint32_t lanes,
                           const float* squared_distances, const WideChildRef& other) {
    while (lanes != 0) {
      const std::uint32_t lane = farthest(lanes, squared_distances);
      lanes &= ~(1u << lane);
      push(side, {first.node, lane, first.treelet}, other);
    }
  }

  HWY_INLINE void count(const WideNode& node, std::uint32_t near) {
    counts_.box_tests += node.count;
    counts_.box_rejections += node.count - static_cast<std::uint32_t>(std::popcount(near));
  }

  HWY_INLINE void compare_leaves(int tested_side, const WideTree::Treelet& tested,
                                 const WideChildRef& tested_leaf, const WideChildRef& query_leaf,
                                 std::uint32_t query_link) {
    const std::uint32_t tested_link = tested_leaf.node->child[tested_leaf.lane];
    counts_.primitive_tests += ChildLink::count(tested_link) * ChildLink::count(query_link);
    set_tested_leaf(tested_leaf_, tested, tested_link);
    const std::uint32_t near =
        near_primitives(tested_leaf_, query_leaf_) &
        pairs_of(ChildLink::count(tested_link), ChildLink::count(query_link));
    if (near != 0) gather(tested_side, tested_leaf, query_leaf, near);
  }

  /// What two leaves are left with. Not inlined: most are left with nothing.
  HWY_NOINLINE void gather(int tested_side, const WideChildRef& tested_leaf,
                           const WideChildRef& query_leaf, std::uint32_t near) {
    const WideTree::Treelet& tested = state_.tree[tested_side]->treelet(tested_leaf.treelet);
    const WideTree::Treelet& query = state_.tree[1 - tested_side]->treelet(query_leaf.treelet);
    const TreeTransform& transform = state_.into[tested_side];
    if (!are_query_edges_set_) set_query_edges(query_edges_, query, query_leaf, transform);
    are_query_edges_set_ = true;
    const PairBatch::Leaves leaves{tested_leaf_, query_leaf_, query_edges_,
                                   tested_edge_error(tested, tested_leaf, transform.slack)};
    const std::uint32_t first =
        tested.first + ChildLink::first(tested_leaf.node->child[tested_leaf.lane]);
    const std::uint32_t first_query =
        query.first + ChildLink::first(query_leaf.node->child[query_leaf.lane]);
    const auto places_of = [&](std::uint32_t pair) HWY_ATTR {
      const std::uint32_t place = first + pair / 4;
      const std::uint32_t place_of_query = first_query + pair % 4;
      return tested_side == 0 ? PlacePair{place, place_of_query} : PlacePair{place_of_query, place};
    };
    state_.last_near = places_of(static_cast<std::uint32_t>(std::countr_zero(near)));
    for (; near != 0; near &= near - 1) {
      const auto pair = static_cast<std::uint32_t>(std::countr_zero(near));
      pairs_.add(leaves, pair / 4, pair % 4, places_of(pair));
      if (pairs_.is_full()) decide();
    }
  }

  HWY_INLINE void decide() {
    if (pairs_.size() != 0) size_ += pairs_.decide(found_.data() + size_);
  }

  WidePairWalk::State& state_;
  std::span<FoundPair> found_;
  WideWalkCounts& counts_;
  std::size_t size_ = 0;
  float scale_b_;
  Query query_{};
  QueryInNode in_node_;
  QueriesInNode queries_in_node_;
  LeafLanes tested_leaf_;
  QueryLeaf query_leaf_;
  LeafInNode leaf_in_node_;
  QueryEdges query_edges_;
  bool are_query_edges_set_ = false;  ///< those of query_leaf_
  PairBatch pairs_;
  alignas(32) float squared_distances_[WideNode::kWidth];
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
