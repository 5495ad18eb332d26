// A pass that updates the front of two wide trees (front tracking: wide_front.h), for each SIMD
// target that the compiler knows.
//
// When a gap was proved, three times the slack of that query was taken off it. A later query has a
// slack of its own: two placed primitives may be nearer by twice that than the trees' frames say
// (engine/mesh/memory/pair_memory.cpp). It is taken off as well, and what was taken off before is
// not counted on to pay for it.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/front/wide_front_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/front/front_outlook-inl.h>
#include <graze/bvh/wide/front/front_pass.h>
#include <graze/bvh/wide/front/leaf_crossings-inl.h>
#include <graze/bvh/wide/front/local_leaves-inl.h>
#include <graze/bvh/wide/lanes/child_refs-inl.h>
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

constexpr float kAtOnce = -std::numeric_limits<float>::infinity();
constexpr float kNever = std::numeric_limits<float>::infinity();

/// How many leaves, and planes, are fetched ahead of the one that is looked at.
constexpr std::size_t kAhead = 6;
constexpr std::size_t kPlanesAhead = 16;

/// The first if `is_first` is 1, the second if it is 0, without a branch.
HWY_INLINE float chosen(std::uint32_t is_first, float first, float second) {
  const auto other = std::bit_cast<std::uint32_t>(second);
  const std::uint32_t change = std::bit_cast<std::uint32_t>(first) ^ other;
  return std::bit_cast<float>(other ^ (change & (0 - is_first)));
}

WideFront::Planes<FrontBounds::Meeting>& planes_of(
    WideFront::State& state, std::integral_constant<FrontBounds, FrontBounds::Meeting> /*of*/) {
  return state.meeting;
}
WideFront::Planes<FrontBounds::Distance>& planes_of(
    WideFront::State& state, std::integral_constant<FrontBounds, FrontBounds::Distance> /*of*/) {
  return state.distance;
}

/// One pass over a front.
template <FrontBounds bounds>
class FrontUpdater {
 public:
  FrontUpdater(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task)
      : state_(state),
        planes_(planes_of(state, std::integral_constant<FrontBounds, bounds>())),
        pass_(pass),
        must_(task.must),
        look_ahead_(task.look_ahead),
        useful_(task.useful),
        most_held_(held() + task.most_added),
        moved_(static_cast<float>(pass.moved) * kRoundDown),
        scale_b_(static_cast<float>(pass.into[0].scale)),
        leaves_(*state.tree[0], *state.tree[1]) {
    for (int side = 0; side < 2; ++side)
      outlook_[side].set(pass, side);
  }

  void run() {
    if (state_.visits.empty()) add_visit({state_.tree[0]->root(), state_.tree[1]->root()});
    const std::size_t visits = state_.visits.size();
    if (look_ahead_.limit > must_.limit && is_look_ahead_in_vain()) look_ahead_ = must_;
    const std::size_t open = find_due(planes_.of_visits, state_.visit_budgets);
    for (std::size_t i = 0; i < open; ++i) {
      if (i + 2 * kAhead < open) {
        fetch(state_.visits[state_.due[i + 2 * kAhead]]);
        fetch(planes_.of_visits[state_.due[i + 2 * kAhead]]);
      }
      if (i + kAhead < open) fetch_visit(state_.due[i + kAhead]);
      visit(state_.due[i]);
    }
    state_.looked_at = open;
    for (std::size_t i = visits; i < state_.visits.size(); ++i) {
      if (i + kAhead < state_.visits.size()) fetch_visit(i + kAhead);
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
  using VisitPlanes = FrontPlanes<WideNode::kWidth, bounds>;
  using LeafPlanes = FrontPlanes<kLeafPairs, bounds>;
  using Outlook = FrontOutlook<bounds>;

  static constexpr bool kIsDistance = bounds == FrontBounds::Distance;

  std::size_t held() const { return state_.visits.size() + state_.leaves.size(); }

  /// Whether so much is within reach that most of it could not be opened, or primitives are so near
  /// that no gap is worth it.
  HWY_INLINE bool is_look_ahead_in_vain() const {
    const std::size_t leaves = find_due(planes_.of_leaves, state_.leaves_budgets);
    for (std::size_t i = 0; i < leaves; ++i) {
      const LeafPlanes& planes = planes_.of_leaves[state_.due[i]];
      if (!(outlook_[planes.query.tested_side].gap(planes) > useful_)) return true;
    }
    const std::size_t near = leaves + find_due(planes_.of_visits, state_.visit_budgets);
    return 2 * near > most_held_ - held();
  }

  HWY_INLINE static float least_of(const std::vector<float>& budgets) {
    const hn::ScalableTag<float> tag;
    const std::size_t lanes = hn::Lanes(tag);
    auto least = hn::Set(tag, kNever);
    std::size_t i = 0;
    for (; i + lanes <= budgets.size(); i += lanes)
      least = hn::Min(least, hn::LoadU(tag, budgets.data() + i));
    float found = hn::GetLane(hn::MinOfLanes(tag, least));
    for (; i < budgets.size(); ++i)
      found = std::min(found, budgets[i]);
    return found;
  }

  /// Compares leaves that are due: which of their primitives may be within the limit.
  HWY_INLINE void compare_due_leaves() {
    const std::size_t near = find_due(planes_.of_leaves, state_.leaves_budgets);
    state_.looked_at += near;
    for (std::size_t i = 0; i < near; ++i)
      compare_leaves(state_.due[i]);
  }

  /// Decides which primitives of leaves that are busy or due meet. In which leaves some do cannot
  /// be predicted, so that no branch depends on it.
  HWY_INLINE void decide_leaves() {
    state_.crossing.size = 0;
    state_.unsure.size = 0;
    separate_leaves(decide_busy());
    const std::size_t near = find_due(planes_.of_leaves, state_.leaves_budgets);
    state_.looked_at += near;
    separate_leaves(near);
  }

  /// Decides all pairs of leaves that have been busy. Those in which no primitives meet any more
  /// are listed at the front of state_.due; returns how many these are.
  HWY_INLINE std::size_t decide_busy() {
    const std::size_t size = state_.busy.size();
    state_.crossing.make_room(size);
    state_.unsure.make_room(size);
    if (state_.due.size() < size) state_.due.resize(2 * size);
    std::size_t busy = 0;
    std::size_t quiet = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (i + 2 * kAhead < size) fetch(state_.leaves[state_.busy[i + 2 * kAhead]]);
      if (i + kAhead < size) fetch_leaves(state_.busy[i + kAhead]);
      const std::uint32_t index = state_.busy[i];
      const std::uint32_t asked = set_leaves(state_.leaves[index]);
      state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
      const PairTag tag;
      Meetings found;
      for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
        const LocalPairs<PairTag> pairs(leaves_, first);
        found.add(LeafCrossings<PairTag>(pairs, leaves_.errors()), first);
      }
      const std::uint32_t open = list(index, asked, found);
      state_.busy[busy] = index;
      state_.due[quiet] = index;
      busy += open != 0;
      quiet += open == 0;
    }
    state_.busy.resize(busy);
    return quiet;
  }

  /// Finds planes between the primitives of the first `count` leaves of state_.due. Those with
  /// pairs that no plane tells apart become busy.
  HWY_INLINE void separate_leaves(std::size_t count) {
    state_.crossing.make_room(count);
    state_.unsure.make_room(count);
    std::size_t busy = state_.busy.size();
    state_.busy.resize(busy + count);
    for (std::size_t i = 0; i < count; ++i) {
      if (i + 2 * kAhead < count) {
        fetch(state_.leaves[state_.due[i + 2 * kAhead]]);
        fetch(planes_.of_leaves[state_.due[i + 2 * kAhead]]);
      }
      if (i + kAhead < count) fetch_leaves(state_.due[i + kAhead]);
      const std::uint32_t index = state_.due[i];
      const WideFront::Leaves& leaves = state_.leaves[index];
      LeafPlanes& planes = planes_.of_leaves[index];
      const std::uint32_t asked = set_leaves(leaves);
      state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
      const PairTag tag;
      Meetings met;
      FoundPlanes<kLeafPairs> gaps;
      for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
        const LocalPairs<PairTag> pairs(leaves_, first);
        const LeafCrossings<PairTag> crossings(pairs, leaves_.errors());
        met.add(crossings, first);
        PrimitiveGaps<PairTag> found(pairs, leaves_.errors().offset);
        found.look_at(crossings);
        const auto is_open = hn::Not(hn::Or(found.are_apart(), crossings.do_cross));
        if ((bits_of(tag, is_open) & asked >> first) != 0) found.look_across();
        found.store(planes, gaps, first, pass_.units[leaves.tested_side]);
      }
      const typename Outlook::Nearness found =
          outlook_[leaves.tested_side].keep(planes, gaps, asked, must_.limit);
      // What planes keep apart does not meet, be it unsure or not.
      list(index, found.near, met);
      const std::uint32_t is_busy = found.near != 0;
      state_.leaves_budgets[index] = chosen(is_busy, kNever, budget_after(found.lasts));
      state_.busy[busy] = index;
      busy += is_busy;
    }
    state_.busy.resize(busy);
  }

  /// Lists at the front of state_.due what has to be looked at again, and returns how many these
  /// are: what is due by its budget, but not what its planes still keep out, which gets a later
  /// budget. There are no branches but the loops, because nothing of it can be predicted.
  template <typename Planes>
  HWY_INLINE std::size_t find_due(const std::vector<Planes>& planes,
                                  std::vector<float>& budgets) const {
    const std::size_t size = list_due(budgets);
    std::uint32_t* const due = state_.due.data();
    std::size_t open = 0;
    for (std::size_t i = 0; i < size; ++i) {
      fetch(planes[due[std::min(i + kPlanesAhead, size - 1)]]);
      const std::uint32_t index = due[i];
      const float later =
          budget_after(outlook_[planes[index].query.tested_side].lasts(planes[index]));
      // False where it is no number. What lasts so long is further apart than the limit.
      const std::uint32_t kept = later > look_ahead_.due;
      budgets[index] = chosen(kept, later, budgets[index]);
      due[open] = index;
      open += 1 - kept;
    }
    return open;
  }

  template <typename Object>
  HWY_INLINE static void fetch(const Object& object) {
    constexpr std::size_t kLine = 64;
    for (std::size_t i = 0; i < sizeof(Object); i += kLine)
      hwy::Prefetch(reinterpret_cast<const char*>(&object) + i);
  }

  /// Lists the indices of all budgets that are spent.
  HWY_INLINE std::size_t list_due(const std::vector<float>& budgets) const {
    const hn::ScalableTag<float> tag;
    const hn::RebindToUnsigned<decltype(tag)> indices;
    const std::size_t lanes = hn::Lanes(tag);
    const std::size_t size = budgets.size();
    if (state_.due.size() < size + lanes) state_.due.resize(2 * size + lanes);
    std::uint32_t* const list = state_.due.data();
    std::size_t count = 0;
    std::size_t i = 0;
    for (; i + lanes <= size; i += lanes) {
      const auto is_due = hn::Le(hn::LoadU(tag, budgets.data() + i), hn::Set(tag, look_ahead_.due));
      count += hn::CompressStore(hn::Iota(indices, static_cast<std::uint32_t>(i)),
                                 hn::RebindMask(indices, is_due), indices, list + count);
    }
    for (; i < size; ++i) {
      list[count] = static_cast<std::uint32_t>(i);
      count += budgets[i] <= look_ahead_.due;
    }
    return count;
  }

  float budget_after(float lasts) const {
    // Rounded down: the sum is not negative where it matters.
    return (moved_ + lasts) * kRoundDown;
  }

  HWY_INLINE void fetch_visit(std::size_t index) const {
    const WideFront::Visit& visit = state_.visits[index];
    fetch(*visit.tested.node);
    fetch(*visit.query.node);
  }

  HWY_INLINE void visit(std::size_t index) {
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
    if (state_.visit_budgets[index] == kAtOnce) {
      planes.query = FrontQuery(query, pass_.units[1 - tested_side], tested_side);
      state_.lanes += node.count;
    }
    const std::uint32_t closed = node.lanes() & ~visit.open;
    FoundPlanes<WideNode::kWidth> gaps;
    set_gaps(planes, gaps, node, tested_side, closed, query);
    const typename Outlook::Nearness kept =
        outlook_[tested_side].keep(planes, gaps, closed, look_ahead_.limit);
    std::uint32_t near = kept.near;
    const auto tested = static_cast<std::uint32_t>(std::popcount(closed));
    state_.counts.box_tests += tested;
    state_.counts.box_rejections += tested - static_cast<std::uint32_t>(std::popcount(near));
    visit.open |= near;
    state_.visit_budgets[index] = budget_after(kept.lasts);
    const FrontQuery placed = planes.query;
    if (held() > most_held_) look_ahead_ = must_;
    for (; near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      const WideChildRef child = {&node, lane, below.treelet};
      const WidePairWalk::Waiting pair = tested_side == 0 ? WidePairWalk::Waiting{child, query}
                                                          : WidePairWalk::Waiting{query, child};
      if (ChildLink::is_leaf(query_link) && ChildLink::is_leaf(node.child[lane])) {
        add_leaves(pair, tested_side, placed);
      } else {
        add_visit(pair);
      }
    }
  }

  /// Of a pair the larger child is opened: it becomes the tested node.
  HWY_INLINE void add_visit(const WidePairWalk::Waiting& pair) {
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
    state_.visit_budgets.push_back(kAtOnce);
  }

  HWY_INLINE WideFront::Leaf leaf_at(int side, const WideChildRef& child) const {
    const std::uint32_t link = child.node->child[child.lane];
    return {child.treelet, link,
            state_.tree[side]->treelet(child.treelet).first + ChildLink::first(link),
            2 * size_of(child)};
  }

  HWY_INLINE void add_leaves(const WidePairWalk::Waiting& pair, int tested_side,
                             const FrontQuery& placed) {
    const WideChildRef& tested = tested_side == 0 ? pair.a : pair.b;
    const WideChildRef& query = tested_side == 0 ? pair.b : pair.a;
    state_.leaves.push_back(
        {leaf_at(tested_side, tested), leaf_at(1 - tested_side, query), tested_side, 0});
    planes_.of_leaves.emplace_back().query = placed;
    state_.leaves_budgets.push_back(kAtOnce);
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

  /// Leaves of large meshes are not in the cache.
  HWY_INLINE void fetch_leaves(std::size_t index) const {
    const WideFront::Leaves& leaves = state_.leaves[index];
    fetch_leaf(leaves.tested_side, leaves.tested);
    fetch_leaf(1 - leaves.tested_side, leaves.query);
  }

  HWY_INLINE void fetch_leaf(int side, const WideFront::Leaf& leaf) const {
    constexpr std::size_t kLine = 64 / sizeof(float);
    const float* rows = rows_of(state_.tree[side]->treelet(leaf.treelet), leaf.link);
    for (std::size_t i = 0; i < CornerRows::kRows * ChildLink::kMaxLeafSize; i += kLine)
      hwy::Prefetch(rows + i);
  }

  /// Sets leaves_. Returns the bits of the pairs that it has.
  HWY_INLINE std::uint32_t set_leaves(const WideFront::Leaves& leaves) {
    leaves_.set(leaves, pass_.into[leaves.tested_side]);
    return leaves_.pairs();
  }

  HWY_INLINE static void add_lanes(WideFront::LeafPairs& pairs, std::uint32_t leaves,
                                   std::uint32_t lanes) {
    const hn::CappedTag<std::uint32_t, kLeafPairs> tag;
    std::uint32_t* const end = pairs.lanes.data();
    for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
      const std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes >> first),
                                    static_cast<std::uint8_t>(lanes >> first >> 8)};
      const auto code = static_cast<std::uint32_t>(kLeafPairs * leaves + first);
      pairs.size += hn::CompressStore(hn::Iota(tag, code), hn::LoadMaskBits(tag, bits), tag,
                                      end + pairs.size);
    }
  }

  /// Which pairs of two leaves surely cross, and which are surely apart.
  struct Meetings {
    std::uint32_t crossing = 0;
    std::uint32_t apart = 0;

    HWY_INLINE void add(const LeafCrossings<PairTag>& some, std::size_t first) {
      crossing |= bits_of(PairTag(), some.do_cross) << first;
      apart |= bits_of(PairTag(), some.are_apart) << first;
    }
  };

  /// Lists those pairs of leaves_ that cross or may cross, and returns their bits.
  HWY_INLINE std::uint32_t list(std::uint32_t index, std::uint32_t asked, const Meetings& found) {
    const std::uint32_t open = asked & ~found.apart;
    add_lanes(state_.crossing, index, open & found.crossing);
    if ((open & ~found.crossing) != 0) add_lanes(state_.unsure, index, open & ~found.crossing);
    return open;
  }

  HWY_INLINE void compare_leaves(std::size_t index) {
    WideFront::Leaves& leaves = state_.leaves[index];
    LeafPlanes& planes = planes_.of_leaves[index];
    const std::uint32_t asked = set_leaves(leaves) & ~leaves.listed;
    state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
    const PairTag tag;
    FoundPlanes<kLeafPairs> gaps;
    for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
      const LocalPairs<PairTag> pairs(leaves_, first);
      const LeafCrossings<PairTag> crossings(pairs, leaves_.errors());
      PrimitiveGaps<PairTag> found(pairs, leaves_.errors().offset);
      found.look_at(crossings);
      found.look_along(pass_.direction[leaves.tested_side]);
      found.store(planes, gaps, first, pass_.units[leaves.tested_side]);
    }
    const typename Outlook::Nearness found =
        outlook_[leaves.tested_side].keep(planes, gaps, asked, must_.limit);
    state_.leaves_budgets[index] = budget_after(found.lasts);
    leaves.listed |= found.near;
    for (std::uint32_t near = found.near; near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      state_.candidates.push_back(static_cast<std::uint32_t>(kLeafPairs * index) + lane);
    }
    state_.candidate_budgets.resize(state_.candidates.size(), kAtOnce);
    state_.candidate_planes.resize(state_.candidates.size());
  }

  WideFront::State& state_;
  WideFront::Planes<bounds>& planes_;
  const WideFront::Pass& pass_;
  FrontHorizon must_;
  FrontHorizon look_ahead_;
  float useful_;
  std::size_t most_held_;  ///< by the front, until it looks no further ahead
  float moved_;            ///< the motion spent, rounded down
  float scale_b_;
  Query query_{};
  WideChildRef query_child_{};  ///< whose box query_ is
  int query_side_ = -1;         ///< of its tree; -1 as long as there is none
  QueryInNode in_node_;
  LocalLeaves leaves_;
  Outlook outlook_[2];  ///< by the side of the tested node
};

void advance(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task) {
  if (pass.bounds == FrontBounds::Distance) {
    FrontUpdater<FrontBounds::Distance>(state, pass, task).run();
  } else {
    FrontUpdater<FrontBounds::Meeting>(state, pass, task).run();
  }
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(advance);

void update_front(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task) {
  HWY_DYNAMIC_DISPATCH(advance)(state, pass, task);
}

}  // namespace graze::bvh
#endif
