// A pass that updates the front of two wide trees (front tracking: wide_front.h), for each SIMD
// target that the compiler knows.
//
// Two slacks are taken off a gap: three times that of the query in which it was proved, as of every
// comparison of boxes (wide_bounds.h), and twice that of the query that uses it. The second is for
// placed primitives that share a point: in the trees' frames some points of theirs lie up to the
// slack apart in each component, and so less than twice the slack apart. Neither slack is counted
// on to cover the other.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/front/wide_front_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/front/box_gaps-inl.h>
#include <graze/bvh/wide/front/front_due-inl.h>
#include <graze/bvh/wide/front/front_leaves-inl.h>
#include <graze/bvh/wide/front/plane_store-inl.h>
#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <graze/bvh/wide/lanes/query_gaps-inl.h>
#include <graze/bvh/wide/lanes/slab_lanes-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Makes one pass over a front.
template <FrontKind kind>
class FrontUpdater : private FrontLeaves<kind> {
 public:
  FrontUpdater(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task)
      : Base(state, pass, task),
        useful_(task.useful),
        most_boxes_and_leaves_(boxes_and_leaves() + task.most_added),
        scale_b_(static_cast<float>(pass.into[0].scale)) {}

  void run() {
    if (state_.visits.empty()) add_visit({state_.tree[0]->root(), state_.tree[1]->root()});
    const std::size_t visits = state_.visits.size();
    if (look_ahead_.limit > required_.limit) end_vain_look_ahead();
    const std::size_t due = renew_budgets(planes_.of_visits, state_.visit_budgets);
    for (std::size_t i = 0; i < due; ++i) {
      if (i + 2 * kAhead < due) {
        prefetch(state_.visits[state_.due[i + 2 * kAhead]]);
        prefetch(planes_.of_visits[state_.due[i + 2 * kAhead]]);
      }
      if (i + kAhead < due) prefetch_visit(state_.due[i + kAhead]);
      visit(state_.due[i]);
    }
    state_.looked_at = due;
    for (std::size_t i = visits; i < state_.visits.size(); ++i) {
      if (i + kAhead < state_.visits.size()) prefetch_visit(i + kAhead);
      visit(i);
    }
    if constexpr (kIsDistance) {
      compare_due_leaves();
    } else {
      decide_leaves();
    }
    if (state_.busy.empty()) {
      state_.least_budget =
          std::min(least_of(state_.visit_budgets), least_of(state_.leaves_budgets));
    }
  }

 private:
  using Base = FrontLeaves<kind>;
  using Base::budget_after;
  using Base::compare_due_leaves;
  using Base::decide_leaves;
  using Base::least_of;
  using Base::look_ahead_;
  using Base::outlook_;
  using Base::pass_;
  using Base::planes_;
  using Base::prefetch;
  using Base::renew_budgets;
  using Base::required_;
  using Base::state_;
  using typename Base::LeafPlanes;
  using typename Base::Outlook;
  using typename Base::VisitPlanes;

  static constexpr bool kIsDistance = kind == FrontKind::Distance;

  std::size_t boxes_and_leaves() const { return state_.visits.size() + state_.leaves.size(); }

  /// Renews budgets, and ends the look-ahead where it is vain: so many pairs are near enough that
  /// most of them could not be opened, or primitives are so near that no gap is worth it.
  HWY_INLINE void end_vain_look_ahead() {
    const std::size_t leaves = renew_budgets(planes_.of_leaves, state_.leaves_budgets);
    for (std::size_t i = 0; i < leaves; ++i) {
      const LeafPlanes& planes = planes_.of_leaves[state_.due[i]];
      if (outlook_[planes.ball.tested_side].gap(planes) > useful_) continue;
      look_ahead_ = required_;
      return;
    }
    const std::size_t near = leaves + renew_budgets(planes_.of_visits, state_.visit_budgets);
    if (2 * near > most_boxes_and_leaves_ - boxes_and_leaves()) look_ahead_ = required_;
  }

  HWY_INLINE void prefetch_visit(std::size_t index) const {
    const WideFront::Visit& visit = state_.visits[index];
    prefetch(*visit.tested.node);
    prefetch(*visit.query.node);
  }

  HWY_NOINLINE void visit(std::size_t index) {
    const WideFront::Visit found = state_.visits[index];
    const int tested_side = found.tested_side;
    const WideChildRef query = found.query;
    const std::uint32_t query_link = query.node->child[query.lane];
    const WideChildRef below = found.tested;
    const TreeTransform& transform = pass_.into[tested_side];
    if (query_side_ != 1 - tested_side || query_child_ != query) {
      set_query(query_, *query.node, query.lane, transform);
      query_child_ = query;
      query_side_ = 1 - tested_side;
    }
    const WideNode& node = *below.node;
    set_query_in_node(in_node_, query_, node,
                      transform.slack + kComparisonError * found.tested_size);
    WideFront::Visit& visit = state_.visits[index];
    VisitPlanes& planes = planes_.of_visits[index];
    if (state_.visit_budgets[index] == kDueNow) {
      planes.ball = QueryBall(query, pass_.units[1 - tested_side], tested_side);
      state_.lanes += node.count;
    }
    const std::uint32_t closed = node.lanes() & ~visit.opened;
    FoundPlanes<WideNode::kWidth> gaps;
    set_gaps(planes, gaps, node, tested_side, closed, query);
    const typename Outlook::Nearness kept =
        outlook_[tested_side].keep(planes, gaps, closed, look_ahead_.limit);
    std::uint32_t near = kept.near;
    const auto tested = static_cast<std::uint32_t>(std::popcount(closed));
    state_.counts.box_tests += tested;
    state_.counts.box_rejections += tested - static_cast<std::uint32_t>(std::popcount(near));
    visit.opened |= near;
    state_.visit_budgets[index] = budget_after(kept.motion_left);
    const QueryBall query_ball = planes.ball;
    if (boxes_and_leaves() > most_boxes_and_leaves_) look_ahead_ = required_;
    for (; near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      const WideChildRef child = {&node, lane, below.treelet};
      const WidePairWalk::Waiting pair = tested_side == 0 ? WidePairWalk::Waiting{child, query}
                                                          : WidePairWalk::Waiting{query, child};
      if (ChildLink::is_leaf(query_link) && ChildLink::is_leaf(node.child[lane])) {
        add_leaves(pair, tested_side, query_ball);
      } else {
        add_visit(pair);
      }
    }
  }

  /// Adds the visit of a pair, whose larger child is opened: it becomes the tested node.
  HWY_NOINLINE void add_visit(const WidePairWalk::Waiting& pair) {
    const std::uint32_t link_a = pair.a.node->child[pair.a.lane];
    const std::uint32_t link_b = pair.b.node->child[pair.b.lane];
    const int tested_side = is_first_opened(pair.a, link_a, pair.b, link_b, scale_b_) ? 0 : 1;
    const WideChildRef& tested = tested_side == 0 ? pair.a : pair.b;
    const WideChildRef below =
        first_below(*state_.tree[tested_side], tested, tested_side == 0 ? link_a : link_b,
                    state_.counts.treelets);
    state_.visits.push_back(
        {below, tested_side == 0 ? pair.b : pair.a, tested_side, size_of(tested), 0});
    planes_.of_visits.emplace_back();
    state_.visit_budgets.push_back(kDueNow);
  }

  HWY_INLINE WideFront::Leaf leaf_at(int side, const WideChildRef& child) const {
    const std::uint32_t link = child.node->child[child.lane];
    return {child.treelet, link,
            state_.tree[side]->treelet(child.treelet).first + ChildLink::first(link),
            2 * size_of(child)};
  }

  HWY_INLINE void add_leaves(const WidePairWalk::Waiting& pair, int tested_side,
                             const QueryBall& query_ball) {
    const WideChildRef& tested = tested_side == 0 ? pair.a : pair.b;
    const WideChildRef& query = tested_side == 0 ? pair.b : pair.a;
    state_.leaves.push_back(
        {leaf_at(tested_side, tested), leaf_at(1 - tested_side, query), tested_side, 0});
    planes_.of_leaves.emplace_back().ball = query_ball;
    state_.leaves_budgets.push_back(kDueNow);
  }

  /// Finds planes between the children of a tested node and query_; only the lanes `asked` matter.
  HWY_INLINE void set_gaps(VisitPlanes& planes, FoundPlanes<WideNode::kWidth>& found,
                           const WideNode& node, int tested_side, std::uint32_t asked,
                           const WideChildRef& query) const {
    const bool are_slabs_asked = node.has_slabs && query.node->has_slabs;
    QuerySlab slab{};
    if (!kIsDistance && are_slabs_asked) {
      slab = slab_of(*query.node, query.lane, static_cast<float>(pass_.into[tested_side].scale),
                     in_node_.padding);
    }
    for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(Tag())) {
      BoxGaps gaps(node, in_node_, lane);
      if constexpr (kIsDistance) {
        gaps.look_along(aim_of(node, in_node_, query_, pass_.direction[tested_side]));
      } else {
        const auto is_any_near = [&]() HWY_ATTR {
          return (bits_of(Tag(), hn::Not(gaps.are_apart())) & asked >> lane) != 0;
        };
        if (is_any_near()) gaps.look_across();
        if (are_slabs_asked && is_any_near()) gaps.look_along_slabs(lane, slab);
      }
      gaps.store(planes, found, lane, pass_.units[tested_side]);
    }
  }

  float useful_;
  std::size_t most_boxes_and_leaves_;  ///< the size up to which the front looks ahead
  float scale_b_;
  Query query_{};
  WideChildRef query_child_{};  ///< the child whose box query_ is
  int query_side_ = -1;         ///< the side of its tree; -1 as long as there is none
  QueryInNode in_node_;
};

void update_front(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task) {
  if (pass.kind == FrontKind::Distance) {
    FrontUpdater<FrontKind::Distance>(state, pass, task).run();
  } else {
    FrontUpdater<FrontKind::Intersection>(state, pass, task).run();
  }
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(update_front);

void update_front(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task) {
  HWY_DYNAMIC_DISPATCH(update_front)(state, pass, task);
}

}  // namespace graze::bvh
#endif
