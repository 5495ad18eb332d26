// A pass over the front of two wide trees, for each SIMD target that the compiler knows.
//
// Bounds are taken with three times the query's slack off, which they had when they were proved.
// Where a later query has a slack of its own, two placed primitives are up to twice that nearer
// than the trees' frames say (engine/mesh/pair_memory.cpp), and what was taken off before is not
// counted on.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/wide_front_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/wide_front.h>
#include <hwy/highway.h>
#include <graze/bvh/wide/front_gaps.inc>
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

/// What is rounded to float, times it, is no more than before.
constexpr float kRoundDown = 1 - 0x1p-22f;

/// What gaps of planes are multiplied by where they are stored, and where they are read: four
/// roundings each, and those of turns.
constexpr float kRoundPlanes = 1 - 0x1p-20f;

using VisitPlanes = FrontPlanes<WideNode::kWidth>;
using LeafPlanes = FrontPlanes<kLeafPairs>;

/// One pass.
class Passer {
 public:
  Passer(WideFront::State& state, const WideFront::Pass& pass, float limit, float due)
      : state_(state),
        pass_(pass),
        limit_(limit),
        due_(due),
        moved_(static_cast<float>(pass.moved) * kRoundDown),
        is_distance_(pass.bounds == WideFront::Bounds::Distance),
        scale_b_(static_cast<float>(pass.into[0].scale)) {}

  void run() {
    const std::size_t visits = state_.visits.size();
    const std::size_t open = find_due(state_.visit_planes, state_.visit_deadlines);
    for (std::size_t i = 0; i < open; ++i)
      visit(state_.due[i]);
    state_.looked_at = open;
    for (std::size_t i = visits; i < state_.visits.size(); ++i)
      visit(i);
    const std::size_t leaves = state_.leaves.size();
    const std::size_t near = find_due(state_.leaf_planes, state_.leaves_deadlines);
    for (std::size_t i = 0; i < near; ++i)
      compare_leaves(state_.due[i]);
    state_.looked_at += near;
    for (std::size_t i = leaves; i < state_.leaves.size(); ++i)
      compare_leaves(i);
  }

 private:
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
      const std::uint32_t index = due[i];
      const float gap = least_gap(planes[index], pass_.since[planes[index].host_side]);
      const float later = deadline_after(gap);
      // Both false where it is no number.
      const bool is_kept = (gap > limit_) & (later > due_);
      deadlines[index] = is_kept ? later : deadlines[index];
      due[open] = index;
      open += !is_kept;
    }
    return open;
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
      const auto is_due = hn::Le(hn::LoadU(tag, deadlines.data() + i), hn::Set(tag, due_));
      count += hn::CompressStore(hn::Iota(indices, static_cast<std::uint32_t>(i)),
                                 hn::RebindMask(indices, is_due), indices, list + count);
    }
    for (; i < size; ++i) {
      list[count] = static_cast<std::uint32_t>(i);
      count += deadlines[i] <= due_;
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

  /// How far the guest's middle has come since the pose of reference.
  HWY_INLINE static void set_step(float (&step)[3], const FrontBall& guest, const FrontWay& way) {
    for (int i = 0; i < 3; ++i) {
      step[i] = way.turned[i][0] * guest.centre[0] + way.turned[i][1] * guest.centre[1] +
                way.turned[i][2] * guest.centre[2] + way.moved[i];
    }
  }

  struct Nearness {
    std::uint32_t near;  // the lanes within the limit
    float least;         // gap of the others
  };

  /// Of these lanes alone, from gaps as they are now, which become those of the pose of reference.
  template <typename Planes>
  HWY_INLINE Nearness keep(Planes& planes, std::uint32_t lanes, const FrontWay& way) const {
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
      const auto is_far = hn::Gt(gap, hn::Set(tag, limit_));
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

  HWY_INLINE void visit(std::size_t index) {
    const WidePairWalk::Waiting pair = state_.visits[index].pair;
    const std::uint32_t link_a = pair.a.node->child[pair.a.lane];
    const std::uint32_t link_b = pair.b.node->child[pair.b.lane];
    if (is_first_opened(pair.a, link_a, pair.b, link_b, scale_b_)) {
      open_host(index, 0, pair.a, link_a, pair.b, link_b);
    } else {
      open_host(index, 1, pair.b, link_b, pair.a, link_a);
    }
  }

  HWY_INLINE void open_host(std::size_t index, int host_side, const WideSlot& host,
                            std::uint32_t host_link, const WideSlot& guest,
                            std::uint32_t guest_link) {
    const WideWay& way = pass_.into[host_side];
    if (guest_side_ != 1 - host_side || guest_slot_ != guest) {
      set_guest(guest_, *guest.node, guest.lane, way);
      guest_slot_ = guest;
      guest_side_ = 1 - host_side;
    }
    const WideSlot below =
        first_below(*state_.tree[host_side], host, host_link, state_.counts.treelets);
    const WideNode& node = *below.node;
    set_guest_in_node(in_node_, guest_, node, way.slack + kComparisonError * size_of(host));
    WideFront::Visit& visit = state_.visits[index];
    VisitPlanes& planes = state_.visit_planes[index];
    if (state_.visit_deadlines[index] == kAtOnce) {
      planes.host_side = host_side;
      planes.guest = FrontBall(guest, pass_.units[1 - host_side]);
    }
    if (state_.visit_deadlines[index] == kAtOnce) state_.lanes += node.count;
    const std::uint32_t closed = node.lanes() & ~visit.open;
    set_gaps(planes, node, host_side, closed);
    const Nearness found = keep(planes, closed, pass_.since[host_side]);
    std::uint32_t near = found.near;
    const auto tested = static_cast<std::uint32_t>(std::popcount(closed));
    state_.counts.box_tests += tested;
    state_.counts.box_rejections += tested - static_cast<std::uint32_t>(std::popcount(near));
    visit.open |= near;
    state_.visit_deadlines[index] = deadline_after(found.least);
    for (; near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      const WideSlot child = {&node, lane, below.treelet};
      const WidePairWalk::Waiting pair = host_side == 0 ? WidePairWalk::Waiting{child, guest}
                                                        : WidePairWalk::Waiting{guest, child};
      if (ChildLink::is_leaf(guest_link) && ChildLink::is_leaf(node.child[lane])) {
        add_leaves(pair, host_side);
      } else {
        add_visit(pair);
      }
    }
  }

  HWY_INLINE void add_visit(const WidePairWalk::Waiting& pair) {
    state_.visits.push_back({pair, 0});
    state_.visit_planes.emplace_back();
    state_.visit_deadlines.push_back(kAtOnce);
  }

  HWY_INLINE void add_leaves(const WidePairWalk::Waiting& pair, int host_side) {
    const WideSlot& guest = host_side == 0 ? pair.b : pair.a;
    state_.leaves.push_back({pair, 0});
    state_.leaf_planes.emplace_back().host_side = host_side;
    state_.leaf_planes.back().guest = FrontBall(guest, pass_.units[1 - host_side]);
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

  HWY_INLINE void compare_leaves(std::size_t index) {
    WideFront::Leaves& leaves = state_.leaves[index];
    LeafPlanes& planes = state_.leaf_planes[index];
    const int host_side = planes.host_side;
    const WideSlot& host_slot = host_side == 0 ? leaves.pair.a : leaves.pair.b;
    const WideSlot& guest_slot = host_side == 0 ? leaves.pair.b : leaves.pair.a;
    const WideTree::Treelet& host = state_.tree[host_side]->treelet(host_slot.treelet);
    const WideTree::Treelet& guest = state_.tree[1 - host_side]->treelet(guest_slot.treelet);
    const std::uint32_t host_link = host_slot.node->child[host_slot.lane];
    const std::uint32_t guest_link = guest_slot.node->child[guest_slot.lane];
    if (leaf_slot_ != guest_slot || leaf_host_ != &host) {
      set_guest_leaf(guest_leaf_, guest, guest_link, host, pass_.into[host_side]);
      leaf_slot_ = guest_slot;
      leaf_host_ = &host;
    }
    set_host_leaf(host_leaf_, host, host_link);
    const std::uint32_t asked =
        pairs_of(ChildLink::count(host_link), ChildLink::count(guest_link)) & ~leaves.listed;
    state_.counts.primitive_tests += static_cast<std::uint32_t>(std::popcount(asked));
    set_leaf_gaps(planes, host_side, asked);
    const Nearness found = keep(planes, asked, pass_.since[host_side]);
    std::uint32_t near = found.near;
    state_.leaves_deadlines[index] = deadline_after(found.least);
    leaves.listed |= near;
    const std::uint32_t first = host.first + ChildLink::first(host_link);
    const std::uint32_t first_guest = guest.first + ChildLink::first(guest_link);
    for (; near != 0; near &= near - 1) {
      const auto place = static_cast<std::uint32_t>(std::countr_zero(near));
      const std::uint32_t of_host = first + place / ChildLink::kMaxLeafSize;
      const std::uint32_t of_guest = first_guest + place % ChildLink::kMaxLeafSize;
      state_.candidates.push_back(
          {host_side == 0 ? PlacePair{of_host, of_guest} : PlacePair{of_guest, of_host},
           static_cast<std::uint32_t>(index), 1u << place});
      state_.candidate_deadlines.push_back(kAtOnce);
    }
  }

  WideFront::State& state_;
  const WideFront::Pass& pass_;
  float limit_;
  float due_;
  float moved_;  // rounded down
  bool is_distance_;
  float scale_b_;
  Guest guest_{};
  WideSlot guest_slot_{};  // of guest_, in the tree of
  int guest_side_ = -1;    // this side, if of any
  GuestInNode in_node_;
  LeafLanes host_leaf_;
  GuestLeaf guest_leaf_;
  WideSlot leaf_slot_{};  // of guest_leaf_, in
  const WideTree::Treelet* leaf_host_ = nullptr;
};

void advance(WideFront::State& state, const WideFront::Pass& pass, float limit, float due) {
  Passer(state, pass, limit, due).run();
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(advance);

namespace {

constexpr float kAtOnce = -std::numeric_limits<float>::infinity();

/// Of vectors that grow.
constexpr std::size_t kFirstSize = 64;

/// What has a deadline up to it is due.
float due_at(const WideFront::Pass& pass, double limit) {
  return rounded_up((pass.moved + limit) + 2 * pass.slack);
}

std::size_t count_due(const std::vector<float>& deadlines, float due) {
  return static_cast<std::size_t>(std::count_if(deadlines.begin(), deadlines.end(),
                                                [due](float deadline) { return deadline <= due; }));
}

}  // namespace

WideFront::Pass::Pass(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b, Bounds what)
    : bounds(what),
      slack(std::max(b_in_a.slack, a_in_b.slack)),
      into{WideWay(b_in_a), WideWay(a_in_b)},
      units{static_cast<float>(b_in_a.units_a), static_cast<float>(a_in_b.units_a)} {}

void WideFront::Pass::aim_along(const double (&along)[3]) {
  const WideWay& of_a_in_b = into[1];
  for (int i = 0; i < 3; ++i) {
    direction[0][i] = static_cast<float>(along[i]);
    direction[1][i] = static_cast<float>(-(of_a_in_b.rotation[i][0] * along[0] +
                                           of_a_in_b.rotation[i][1] * along[1] +
                                           of_a_in_b.rotation[i][2] * along[2]));
  }
}

WideFront::Pass WideFront::pass(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b,
                                Bounds bounds, const Motion& motion) const {
  Pass pass(b_in_a, a_in_b, bounds);
  pass.moved = motion.way;
  pass.since[0] = FrontWay(first_[0], b_in_a, *state_.tree[1], motion.turn);
  pass.since[1] = FrontWay(first_[1], a_in_b, *state_.tree[0], motion.turn);
  return pass;
}

void WideFront::begin(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
                      const RelativeFrame& a_in_b) {
  first_[0] = b_in_a;
  first_[1] = a_in_b;
  state_.tree[0] = &tree_a;
  state_.tree[1] = &tree_b;
  state_.visits.reserve(kFirstSize);
  state_.visit_planes.reserve(kFirstSize);
  state_.leaves.reserve(kFirstSize);
  state_.leaf_planes.reserve(kFirstSize);
  state_.visits.assign(1, {{tree_a.root(), tree_b.root()}, 0});
  state_.visit_planes.assign(1, {});
  state_.visit_deadlines.assign(1, kAtOnce);
  state_.leaves.clear();
  state_.leaf_planes.clear();
  state_.leaves_deadlines.clear();
  state_.candidates.clear();
  state_.candidate_deadlines.clear();
  state_.lanes = 0;
}

void WideFront::arrange(std::span<const std::uint32_t> order) {
  const std::vector<Candidate> candidates = state_.candidates;
  const std::vector<float> deadlines = state_.candidate_deadlines;
  for (std::size_t i = 0; i < order.size(); ++i) {
    state_.candidates[i] = candidates[order[i]];
    state_.candidate_deadlines[i] = deadlines[order[i]];
  }
}

double WideFront::share_due(const Pass& pass, double limit) const {
  const float due = due_at(pass, limit);
  const std::size_t all = state_.visits.size() + state_.leaves.size();
  return static_cast<double>(count_due(state_.visit_deadlines, due) +
                             count_due(state_.leaves_deadlines, due)) /
         static_cast<double>(all);
}

void WideFront::advance(const Pass& pass, double limit) {
  const std::uint64_t before = state_.counts.box_tests;
  const std::uint64_t known = state_.lanes;
  const float float_limit = limit > 0 ? rounded_up(limit) : 0;
  HWY_DYNAMIC_DISPATCH(advance)(state_, pass, float_limit, due_at(pass, limit));
  const std::uint64_t tested = state_.counts.box_tests - before;
  skipped_ += known > tested ? known - tested : 0;
}

bool WideFront::is_due(std::size_t index, const Pass& pass, double limit) const {
  return state_.candidate_deadlines[index] <= due_at(pass, limit);
}

void WideFront::set_gap(std::size_t index, const Pass& pass, double gap) {
  state_.candidate_deadlines[index] = rounded_down(pass.moved + gap);
}

void WideFront::drop(std::size_t index) {
  const Candidate candidate = state_.candidates[index];
  Leaves& leaves = state_.leaves[candidate.leaves];
  leaves.listed &= ~candidate.bit;
  state_.leaf_planes[candidate.leaves].gap[std::countr_zero(candidate.bit)] = kAtOnce;
  state_.leaves_deadlines[candidate.leaves] = kAtOnce;
  state_.candidates[index] = state_.candidates.back();
  state_.candidate_deadlines[index] = state_.candidate_deadlines.back();
  state_.candidates.pop_back();
  state_.candidate_deadlines.pop_back();
}

double WideFront::proven_gap(const Pass& pass) const {
  float least = std::numeric_limits<float>::infinity();
  for (const std::vector<float>* deadlines :
       {&state_.visit_deadlines, &state_.leaves_deadlines, &state_.candidate_deadlines}) {
    for (const float deadline : *deadlines)
      least = std::min(least, deadline);
  }
  return (static_cast<double>(least) - pass.moved) - 2 * pass.slack;
}

WideFront::Counts WideFront::take_counts() {
  const Counts counts{state_.counts, skipped_};
  state_.counts = {};
  skipped_ = 0;
  return counts;
}

}  // namespace graze::bvh
#endif
