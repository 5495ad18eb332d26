// A pass over the front of two wide trees, for each SIMD target that the compiler knows.
//
// Bounds are taken with three times the query's slack off, which they had when they were proved.
// Where a later query has a slack of its own, two placed primitives are up to twice that nearer
// than the trees' frames say (engine/mesh/pair_memory.cpp), and what was taken off before is not
// counted on.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/wide_front_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/front_pass.h>
#include <hwy/cache_control.h>
#include <hwy/highway.h>
#include <graze/bvh/wide/front_gaps.inc>
#include <graze/bvh/wide/leaf_crossings.inc>
#include <graze/bvh/wide/local_leaves.inc>
#include <graze/bvh/wide/slots.inc>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

constexpr float kAtOnce = -std::numeric_limits<float>::infinity();
constexpr float kNever = std::numeric_limits<float>::infinity();

/// Leaves are fetched so many before they are looked at.
constexpr std::size_t kAhead = 6;
constexpr std::size_t kPlanesAhead = 16;

using VisitPlanes = FrontPlanes<WideNode::kWidth>;
using LeafPlanes = FrontPlanes<kLeafPairs>;

/// One pass.
class Passer {
 public:
  Passer(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task)
      : state_(state),
        pass_(pass),
        must_(task.must),
        reach_(task.reach),
        useful_(task.useful),
        most_held_(held() + task.most_added),
        moved_(static_cast<float>(pass.moved) * kRoundDown),
        is_distance_(pass.bounds == WideFront::Bounds::Distance),
        scale_b_(static_cast<float>(pass.into[0].scale)) {}

  void run() {
    if (state_.visits.empty()) add_visit({state_.tree[0]->root(), state_.tree[1]->root()});
    const std::size_t visits = state_.visits.size();
    if (reach_.limit > must_.limit && is_reach_in_vain()) reach_ = must_;
    const std::size_t open = find_due(state_.visit_planes, state_.visit_deadlines);
    for (std::size_t i = 0; i < open; ++i) {
      if (i + 2 * kAhead < open) {
        fetch(state_.visits[state_.due[i + 2 * kAhead]]);
        fetch(state_.visit_planes[state_.due[i + 2 * kAhead]]);
      }
      if (i + kAhead < open) fetch_visit(state_.due[i + kAhead]);
      visit(state_.due[i]);
    }
    state_.looked_at = open;
    for (std::size_t i = visits; i < state_.visits.size(); ++i) {
      if (i + kAhead < state_.visits.size()) fetch_visit(i + kAhead);
      visit(i);
    }
    if (is_distance_) {
      compare_due_leaves();
    } else {
      decide_leaves();
    }
    if (state_.busy.empty()) {
      state_.least_deadline =
          std::min(least_of(state_.visit_deadlines), least_of(state_.leaves_deadlines));
    }
  }

 private:
  std::size_t held() const { return state_.visits.size() + state_.leaves.size(); }

  /// Whether so much is within reach that most of it could not be opened, or primitives are so near
  /// that no gap is worth it.
  HWY_INLINE bool is_reach_in_vain() const {
    const std::size_t leaves = find_due(state_.leaf_planes, state_.leaves_deadlines);
    for (std::size_t i = 0; i < leaves; ++i) {
      const LeafPlanes& planes = state_.leaf_planes[state_.due[i]];
      if (!(least_gap(planes, pass_.since[planes.host_side]) > useful_)) return true;
    }
    const std::size_t near = leaves + find_due(state_.visit_planes, state_.visit_deadlines);
    return 2 * near > most_held_ - held();
  }

  HWY_INLINE static float least_of(const std::vector<float>& deadlines) {
    const hn::ScalableTag<float> tag;
    const std::size_t lanes = hn::Lanes(tag);
    auto least = hn::Set(tag, kNever);
    std::size_t i = 0;
    for (; i + lanes <= deadlines.size(); i += lanes)
      least = hn::Min(least, hn::LoadU(tag, deadlines.data() + i));
    float found = hn::GetLane(hn::MinOfLanes(tag, least));
    for (; i < deadlines.size(); ++i)
      found = std::min(found, deadlines[i]);
    return found;
  }

  /// Leaves that are due: which of their primitives may be within the limit.
  HWY_INLINE void compare_due_leaves() {
    const std::size_t near = find_due(state_.leaf_planes, state_.leaves_deadlines);
    state_.looked_at += near;
    for (std::size_t i = 0; i < near; ++i)
      compare_leaves(state_.due[i]);
  }

  /// Leaves that are busy or due: which of their primitives meet.
  HWY_INLINE void decide_leaves() {
    state_.crossing.size = 0;
    state_.unsure.size = 0;
    state_.crossing.make_room(state_.busy.size());
    state_.unsure.make_room(state_.busy.size());
    std::size_t busy = 0;
    for (std::size_t i = 0; i < state_.busy.size(); ++i) {
      if (i + 2 * kAhead < state_.busy.size()) fetch(state_.leaves[state_.busy[i + 2 * kAhead]]);
      if (i + kAhead < state_.busy.size()) fetch_leaves(state_.busy[i + kAhead]);
      const std::uint32_t index = state_.busy[i];
      state_.busy[busy] = index;
      busy += is_busy(index);
    }
    state_.busy.resize(busy);
    const std::size_t near = find_due(state_.leaf_planes, state_.leaves_deadlines);
    state_.looked_at += near;
    state_.crossing.make_room(near);
    state_.unsure.make_room(near);
    for (std::size_t i = 0; i < near; ++i) {
      if (i + 2 * kAhead < near) {
        fetch(state_.leaves[state_.due[i + 2 * kAhead]]);
        fetch(state_.leaf_planes[state_.due[i + 2 * kAhead]]);
      }
      if (i + kAhead < near) fetch_leaves(state_.due[i + kAhead]);
      const std::uint32_t index = state_.due[i];
      const std::uint32_t asked = set_leaves(state_.leaves[index]);
      // Where nothing has met so far nothing will.
      if (state_.crossing.empty() && is_kept_out(index)) continue;
      if (!decide(index, asked) && is_kept_out(index)) continue;
      state_.leaves_deadlines[index] = kNever;
      state_.busy.push_back(index);
    }
    // Only where nothing meets is there a gap to be told.
    if (state_.crossing.empty() && state_.unsure.empty()) calm_down();
  }

  /// Finds planes for whatever is busy, as far as there are any.
  HWY_INLINE void calm_down() {
    std::size_t busy = 0;
    for (const std::uint32_t index : state_.busy) {
      set_leaves(state_.leaves[index]);
      if (!is_kept_out(index)) state_.busy[busy++] = index;
    }
    state_.busy.resize(busy);
  }

  /// Puts first in state_.due what has to be looked at again; how many these are. What is due by
  /// its deadline, but for what its planes still keep out: that is due later. No branches but the
  /// loops: nothing of it can be foretold.
  template <typename Planes>
  HWY_INLINE std::size_t find_due(const std::vector<Planes>& planes,
                                  std::vector<float>& deadlines) const {
    const std::size_t size = list_due(deadlines);
    std::uint32_t* const due = state_.due.data();
    std::size_t open = 0;
    for (std::size_t i = 0; i < size; ++i) {
      fetch(planes[due[std::min(i + kPlanesAhead, size - 1)]]);
      const std::uint32_t index = due[i];
      const float gap = least_gap(planes[index], pass_.since[planes[index].host_side]);
      const float later = deadline_after(gap);
      // Both false where it is no number.
      const bool is_kept = (gap > reach_.limit) & (later > reach_.due);
      deadlines[index] = is_kept ? later : deadlines[index];
      due[open] = index;
      open += !is_kept;
    }
    return open;
  }

  template <typename Object>
  HWY_INLINE static void fetch(const Object& object) {
    constexpr std::size_t kLine = 64;
    for (std::size_t i = 0; i < sizeof(Object); i += kLine)
      hwy::Prefetch(reinterpret_cast<const char*>(&object) + i);
  }

  /// The indices of all deadlines that are up.
  HWY_INLINE std::size_t list_due(const std::vector<float>& deadlines) const {
    const hn::ScalableTag<float> tag;
    const hn::RebindToUnsigned<decltype(tag)> indices;
    const std::size_t lanes = hn::Lanes(tag);
    const std::size_t size = deadlines.size();
    if (state_.due.size() < size + lanes) state_.due.resize(2 * size + lanes);
    std::uint32_t* const list = state_.due.data();
    std::size_t count = 0;
    std::size_t i = 0;
    for (; i + lanes <= size; i += lanes) {
      const auto is_due = hn::Le(hn::LoadU(tag, deadlines.data() + i), hn::Set(tag, reach_.due));
      count += hn::CompressStore(hn::Iota(indices, static_cast<std::uint32_t>(i)),
                                 hn::RebindMask(indices, is_due), indices, list + count);
    }
    for (; i < size; ++i) {
      list[count] = static_cast<std::uint32_t>(i);
      count += deadlines[i] <= reach_.due;
    }
    return count;
  }

  float deadline_after(float gap) const {
    // Rounded down: the sum is not negative where it matters.
    return gap < kNever ? (moved_ + gap) * kRoundDown : kNever;
  }

  /// The least of the gaps that planes prove now.
  template <typename Planes>
  HWY_INLINE float least_gap(const Planes& planes, const FrontWay& way) const {
    const hn::CappedTag<float, Planes::kLanes> tag;
    float step[3];
    set_step(step, planes.guest, way);
    const auto lost = hn::Set(tag, planes.guest.radius * way.turn * (1 / kRoundPlanes) + way.error);
    auto least = hn::Set(tag, kNever);
    for (std::size_t lane = 0; lane < Planes::kLanes; lane += hn::Lanes(tag)) {
      auto gap = hn::Load(tag, planes.gap + lane);
      for (int i = 0; i < 3; ++i)
        gap = hn::MulAdd(hn::Load(tag, planes.normal[i] + lane), hn::Set(tag, step[i]), gap);
      least = hn::Min(least, hn::Sub(gap, lost));
    }
    return hn::GetLane(hn::MinOfLanes(tag, least)) * kRoundPlanes;
  }

  struct Nearness {
    std::uint32_t near;  // the lanes within the limit
    float least;         // gap of the others
  };

  /// Of these lanes alone, from gaps as they are now, which become those of the pose of reference.
  template <typename Planes>
  HWY_INLINE Nearness keep(Planes& planes, std::uint32_t lanes, const FrontWay& way,
                           float limit) const {
    const hn::CappedTag<float, Planes::kLanes> tag;
    float step[3];
    set_step(step, planes.guest, way);
    const auto gained = hn::Set(tag, planes.guest.radius * way.turn * kRoundPlanes - way.error);
    std::uint32_t near = 0;
    auto least = hn::Set(tag, kNever);
    for (std::size_t lane = 0; lane < Planes::kLanes; lane += hn::Lanes(tag)) {
      const std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes >> lane),
                                    static_cast<std::uint8_t>(lanes >> lane >> 8)};
      const auto is_asked = hn::LoadMaskBits(tag, bits);
      const auto gap = hn::Load(tag, planes.gap + lane);
      const auto is_far = hn::Gt(gap, hn::Set(tag, limit));
      const auto is_kept = hn::And(is_far, is_asked);
      least = hn::Min(least, hn::IfThenElse(is_kept, gap, least));
      near |= bits_of(tag, hn::AndNot(is_far, is_asked)) << lane;
      auto stored = hn::Mul(gap, hn::Set(tag, kRoundPlanes));
      for (int i = 0; i < 3; ++i)
        stored =
            hn::NegMulAdd(hn::Load(tag, planes.normal[i] + lane), hn::Set(tag, step[i]), stored);
      stored = hn::IfThenElse(is_kept, hn::Add(stored, gained), hn::Set(tag, kNever));
      hn::Store(stored, tag, planes.gap + lane);
    }
    return {near, hn::GetLane(hn::MinOfLanes(tag, least))};
  }

  HWY_INLINE void fetch_visit(std::size_t index) const {
    const WideFront::Visit& visit = state_.visits[index];
    fetch(*visit.host.node);
    fetch(*visit.guest.node);
  }

  HWY_INLINE void visit(std::size_t index) {
    const WideFront::Visit found = state_.visits[index];
    const int host_side = found.host_side;
    const WideSlot guest = found.guest;
    const std::uint32_t guest_link = guest.node->child[guest.lane];
    const WideSlot below = found.host;
    const WideWay& way = pass_.into[host_side];
    if (guest_side_ != 1 - host_side || guest_slot_ != guest) {
      set_guest(guest_, *guest.node, guest.lane, way);
      guest_slot_ = guest;
      guest_side_ = 1 - host_side;
    }
    const WideNode& node = *below.node;
    set_guest_in_node(in_node_, guest_, node, way.slack + kComparisonError * found.host_size);
    WideFront::Visit& visit = state_.visits[index];
    VisitPlanes& planes = state_.visit_planes[index];
    if (state_.visit_deadlines[index] == kAtOnce) {
      planes.host_side = host_side;
      planes.guest = FrontBall(guest, pass_.units[1 - host_side]);
      state_.lanes += node.count;
    }
    const std::uint32_t closed = node.lanes() & ~visit.open;
    set_gaps(planes, node, host_side, closed);
    const Nearness kept = keep(planes, closed, pass_.since[host_side], reach_.limit);
    std::uint32_t near = kept.near;
    const auto tested = static_cast<std::uint32_t>(std::popcount(closed));
    state_.counts.box_tests += tested;
    state_.counts.box_rejections += tested - static_cast<std::uint32_t>(std::popcount(near));
    visit.open |= near;
    state_.visit_deadlines[index] = deadline_after(kept.least);
    const FrontBall ball = planes.guest;
    if (held() > most_held_) reach_ = must_;
    for (; near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      const WideSlot child = {&node, lane, below.treelet};
      const WidePairWalk::Waiting pair = host_side == 0 ? WidePairWalk::Waiting{child, guest}
                                                        : WidePairWalk::Waiting{guest, child};
      if (ChildLink::is_leaf(guest_link) && ChildLink::is_leaf(node.child[lane])) {
        add_leaves(pair, host_side, ball);
      } else {
        add_visit(pair);
      }
    }
  }

  /// The larger is opened: it is the host.
  HWY_INLINE void add_visit(const WidePairWalk::Waiting& pair) {
    const std::uint32_t link_a = pair.a.node->child[pair.a.lane];
    const std::uint32_t link_b = pair.b.node->child[pair.b.lane];
    const int host_side = is_first_opened(pair.a, link_a, pair.b, link_b, scale_b_) ? 0 : 1;
    const WideSlot& host = host_side == 0 ? pair.a : pair.b;
    const WideSlot below = first_below(*state_.tree[host_side], host,
                                       host_side == 0 ? link_a : link_b, state_.counts.treelets);
    state_.visits.push_back({below, host_side == 0 ? pair.b : pair.a, host_side, size_of(host), 0});
    state_.visit_planes.emplace_back();
    state_.visit_deadlines.push_back(kAtOnce);
  }

  HWY_INLINE WideFront::Leaf leaf_at(int side, const WideSlot& slot) const {
    const std::uint32_t link = slot.node->child[slot.lane];
    return {slot.treelet, link,
            state_.tree[side]->treelet(slot.treelet).first + ChildLink::first(link)};
  }

  HWY_INLINE void add_leaves(const WidePairWalk::Waiting& pair, int host_side,
                             const FrontBall& ball) {
    const WideSlot& host = host_side == 0 ? pair.a : pair.b;
    const WideSlot& guest = host_side == 0 ? pair.b : pair.a;
    state_.leaves.push_back(
        {leaf_at(host_side, host), leaf_at(1 - host_side, guest), host_side, 0});
    state_.leaf_planes.emplace_back().host_side = host_side;
    state_.leaf_planes.back().guest = ball;
    state_.leaves_deadlines.push_back(kAtOnce);
  }

  /// Of the children of a host beside guest_; of these lanes it matters.
  HWY_INLINE void set_gaps(VisitPlanes& planes, const WideNode& node, int host_side,
                           std::uint32_t asked) const {
    for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(Tag())) {
      BoxGaps gaps(node, in_node_, guest_, lane);
      if (is_distance_) {
        gaps.look_along(aim_of(node, in_node_, guest_, pass_.direction[host_side]));
      } else if ((bits_of(Tag(), hn::Not(gaps.are_apart())) & asked >> lane) != 0) {
        gaps.look_across();
      }
      gaps.store(planes, lane, pass_.units[host_side]);
    }
  }

  /// Of all pairs of the primitives of host_leaf_ and guest_leaf_; of these lanes it matters.
  HWY_INLINE void set_leaf_gaps(LeafPlanes& planes, int host_side, std::uint32_t asked) const {
    const PairTag tag;
    for (std::size_t first = 0; first < kLeafPairs; first += hn::Lanes(tag)) {
      const PairLanes<PairTag> pairs(first);
      const PairBoxes<PairTag> boxes(pairs, host_leaf_, guest_leaf_);
      const PairTriangles<PairTag> triangles(pairs, host_leaf_, guest_leaf_);
      PrimitiveGaps<PairTag> gaps(boxes, triangles, guest_leaf_.error);
      if (is_distance_) gaps.look_along(pass_.direction[host_side]);
      if (!is_distance_ && (bits_of(tag, hn::Not(gaps.are_apart())) & asked >> first) != 0)
        gaps.look_across();
      gaps.store(planes, first, pass_.units[host_side]);
    }
  }

  /// Leaves of large meshes are not in the cache.
  HWY_INLINE void fetch_leaves(std::size_t index) const {
    const WideFront::Leaves& leaves = state_.leaves[index];
    fetch_leaf(leaves.host_side, leaves.host);
    fetch_leaf(1 - leaves.host_side, leaves.guest);
  }

  HWY_INLINE void fetch_leaf(int side, const WideFront::Leaf& leaf) const {
    constexpr std::size_t kLine = 64 / sizeof(float);
    const float* rows = rows_of(state_.tree[side]->treelet(leaf.treelet), leaf.link);
    for (std::size_t i = 0; i < CornerRows::kRows * ChildLink::kMaxLeafSize; i += kLine)
      hwy::Prefetch(rows + i);
  }

  /// Two leaves become host_leaf_ and guest_leaf_. Returns which pairs they have.
  HWY_INLINE std::uint32_t set_leaves(const WideFront::Leaves& leaves) {
    const WideTree::Treelet& host = state_.tree[leaves.host_side]->treelet(leaves.host.treelet);
    const WideTree::Treelet& guest =
        state_.tree[1 - leaves.host_side]->treelet(leaves.guest.treelet);
    const WideWay& way = pass_.into[leaves.host_side];
    if (between_.host != &host || between_.guest != &guest || between_.way != &way)
      set_treelet_way(between_, host, guest, way);
    set_local_leaves(host_leaf_, guest_leaf_, {host, leaves.host.link}, {guest, leaves.guest.link},
                     between_);
    return pairs_of(ChildLink::count(leaves.host.link), ChildLink::count(leaves.guest.link));
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

  /// Decides all pairs of two leaves. Whether some meet, or did so a short time ago, or cannot be
  /// kept out by planes. Which pairs meet cannot be foretold: there are no branches on that.
  HWY_INLINE bool is_busy(std::uint32_t index) {
    const std::uint32_t asked = set_leaves(state_.leaves[index]);
    return decide(index, asked) || !is_kept_out(index);
  }

  /// Of these pairs of host_leaf_ and guest_leaf_: lists those that cross or may. Whether there are
  /// any.
  HWY_INLINE bool decide(std::uint32_t index, std::uint32_t asked) {
    state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
    const LeafCrossings found = leaf_crossings(host_leaf_, guest_leaf_);
    const std::uint32_t open = asked & ~found.apart;
    add_lanes(state_.crossing, index, open & found.crossing);
    if ((open & ~found.crossing) != 0) add_lanes(state_.unsure, index, open & ~found.crossing);
    return open != 0;
  }

  /// Looks for planes between the primitives of host_leaf_ and guest_leaf_, until they are due
  /// again.
  HWY_INLINE bool is_kept_out(std::size_t index) {
    const WideFront::Leaves& leaves = state_.leaves[index];
    LeafPlanes& planes = state_.leaf_planes[index];
    const std::uint32_t asked =
        pairs_of(ChildLink::count(leaves.host.link), ChildLink::count(leaves.guest.link));
    set_leaf_gaps(planes, leaves.host_side, asked);
    const Nearness found = keep(planes, asked, pass_.since[leaves.host_side], must_.limit);
    state_.leaves_deadlines[index] = found.near == 0 ? deadline_after(found.least) : kNever;
    return found.near == 0;
  }

  HWY_INLINE void compare_leaves(std::size_t index) {
    WideFront::Leaves& leaves = state_.leaves[index];
    LeafPlanes& planes = state_.leaf_planes[index];
    const std::uint32_t asked = set_leaves(leaves) & ~leaves.listed;
    state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
    set_leaf_gaps(planes, leaves.host_side, asked);
    const Nearness found = keep(planes, asked, pass_.since[leaves.host_side], must_.limit);
    state_.leaves_deadlines[index] = deadline_after(found.least);
    leaves.listed |= found.near;
    for (std::uint32_t near = found.near; near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      state_.candidates.push_back(static_cast<std::uint32_t>(kLeafPairs * index) + lane);
    }
    state_.candidate_deadlines.resize(state_.candidates.size(), kAtOnce);
    state_.candidate_planes.resize(state_.candidates.size());
  }

  WideFront::State& state_;
  const WideFront::Pass& pass_;
  FrontHorizon must_;
  FrontHorizon reach_;
  float useful_;
  std::size_t most_held_;  // what it opens until then may be within reach_
  float moved_;            // rounded down
  bool is_distance_;
  float scale_b_;
  Guest guest_{};
  WideSlot guest_slot_{};  // of guest_, in the tree of
  int guest_side_ = -1;    // this side, if of any
  GuestInNode in_node_;
  TreeletWay between_;
  LeafLanes host_leaf_;
  GuestLeaf guest_leaf_;
};

void advance(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task) {
  Passer(state, pass, task).run();
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(advance);

void pass_over(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task) {
  HWY_DYNAMIC_DISPATCH(advance)(state, pass, task);
}

}  // namespace graze::bvh
#endif
