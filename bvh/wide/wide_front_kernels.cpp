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
#include <graze/bvh/wide/leaf_gaps.inc>
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

/// What is further counts as so far: squares of it may have overflowed.
constexpr float kFarthest = static_cast<float>(WideFront::kFarthest);

/// What is rounded to float, times it, is no more than before.
constexpr float kRoundDown = 1 - 0x1p-22f;

/// Pays for kBoundGrowth, roots and products.
constexpr float kShrink = 1 - 0x1p-13f;

/// How far the children of a host are from a guest at least, along the axis that says most. Cross
/// products of axes are no longer than 1, so that gaps along them are no larger than distances.
HWY_INLINE void set_gaps(float* gaps, const WideNode& host, const GuestInNode& guest,
                         float unit_of_host) {
  const Tag tag;
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    Lanes half[3], way[3];
    Lanes gap = hn::Zero(tag);
    for (int i = 0; i < 3; ++i) {
      half[i] = hn::Load(tag, host.half[i] + lane);
      way[i] = hn::Sub(hn::Set(tag, guest.way[i]), hn::Load(tag, host.centre[i] + lane));
      gap = hn::Max(gap, hn::Sub(hn::Abs(way[i]), hn::Add(half[i], hn::Set(tag, guest.reach[i]))));
    }
    for (int k = 0; k < 3; ++k) {
      const Lanes distance =
          hn::MulAdd(way[0], hn::Set(tag, guest.axes[k][0]),
                     hn::MulAdd(way[1], hn::Set(tag, guest.axes[k][1]),
                                hn::Mul(way[2], hn::Set(tag, guest.axes[k][2]))));
      const Lanes reach = hn::MulAdd(half[0], hn::Set(tag, guest.size[k][0]),
                                     hn::MulAdd(half[1], hn::Set(tag, guest.size[k][1]),
                                                hn::MulAdd(half[2], hn::Set(tag, guest.size[k][2]),
                                                           hn::Set(tag, guest.half[k]))));
      gap = hn::Max(gap, hn::Sub(hn::Abs(distance), reach));
    }
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        const Lanes distance = hn::MulSub(way[i2], hn::Set(tag, guest.axes[k][i1]),
                                          hn::Mul(way[i1], hn::Set(tag, guest.axes[k][i2])));
        const Lanes reach = hn::MulAdd(half[i1], hn::Set(tag, guest.size[k][i2]),
                                       hn::MulAdd(half[i2], hn::Set(tag, guest.size[k][i1]),
                                                  hn::Set(tag, guest.crossed[k][i])));
        gap = hn::Max(gap, hn::Sub(hn::Abs(distance), reach));
      }
    }
    hn::Store(hn::Mul(known(tag, gap), hn::Set(tag, unit_of_host * kShrink)), tag, gaps + lane);
  }
}

/// Of so many squared bounds.
template <typename Tag>
HWY_INLINE void set_roots(Tag tag, float* gaps, const float* squares, std::size_t count) {
  for (std::size_t lane = 0; lane < count; lane += hn::Lanes(tag)) {
    const auto gap = hn::Min(hn::Sqrt(hn::Load(tag, squares + lane)), hn::Set(tag, kFarthest));
    hn::Store(hn::Mul(gap, hn::Set(tag, kShrink)), tag, gaps + lane);
  }
}

/// One pass.
class Passer {
 public:
  Passer(WideFront::State& state, const WideFront::Pass& pass, float limit, float due)
      : state_(state),
        pass_(pass),
        limit_(limit),
        due_(due),
        is_distance_(pass.bounds == WideFront::Bounds::Distance),
        scale_b_(static_cast<float>(pass.into[0].scale)) {}

  void run() {
    for (std::size_t i = 0; i < state_.visits.size();) {
      i = next_due(state_.visit_deadlines, i);
      if (i < state_.visits.size()) visit(i++);
    }
    for (std::size_t i = 0; i < state_.leaves.size();) {
      i = next_due(state_.leaves_deadlines, i);
      if (i < state_.leaves.size()) compare_leaves(i++);
    }
  }

 private:
  HWY_INLINE std::size_t next_due(const std::vector<float>& deadlines, std::size_t from) const {
    const hn::ScalableTag<float> tag;
    const std::size_t lanes = hn::Lanes(tag);
    const std::size_t size = deadlines.size();
    const auto due = hn::Set(tag, due_);
    std::size_t i = from;
    for (; i + lanes <= size; i += lanes) {
      const auto is_due = hn::Le(hn::LoadU(tag, deadlines.data() + i), due);
      if (!hn::AllFalse(tag, is_due))
        return i + static_cast<std::size_t>(hn::FindFirstTrue(tag, is_due));
    }
    while (i < size && deadlines[i] > due_)
      ++i;
    return i;
  }

  float deadline_after(float gap) const {
    // Rounded down: the sum is not negative.
    return gap < kNever ? static_cast<float>(pass_.moved + static_cast<double>(gap)) * kRoundDown
                        : kNever;
  }

  struct Nearness {
    std::uint32_t near;  // the lanes within the limit
    float least;         // gap of the others
  };

  /// Of these lanes alone.
  template <typename Tag>
  HWY_INLINE Nearness nearness(Tag tag, const float* gaps, std::size_t count,
                               std::uint32_t lanes) const {
    std::uint32_t near = 0;
    auto least = hn::Set(tag, kNever);
    for (std::size_t lane = 0; lane < count; lane += hn::Lanes(tag)) {
      const std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes >> lane)};
      const auto is_asked = hn::LoadMaskBits(tag, bits);
      const auto gap = hn::Load(tag, gaps + lane);
      const auto is_far = hn::Gt(gap, hn::Set(tag, limit_));
      least = hn::Min(least, hn::IfThenElse(hn::And(is_far, is_asked), gap, least));
      std::uint8_t near_bits[8] = {};
      hn::StoreMaskBits(tag, hn::AndNot(is_far, is_asked), near_bits);
      near |= std::uint32_t{near_bits[0]} << lane;
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
    alignas(32) float gaps[WideNode::kWidth];
    if (is_distance_) {
      set_promises(promises_, node, in_node_,
                   aim_of(node, in_node_, guest_, pass_.direction[host_side]),
                   pass_.units[host_side]);
      set_roots(Tag(), gaps, promises_.bound, WideNode::kWidth);
    } else {
      set_gaps(gaps, node, in_node_, pass_.units[host_side]);
    }
    WideFront::Visit& visit = state_.visits[index];
    if (state_.visit_deadlines[index] == kAtOnce) state_.lanes += node.count;
    const std::uint32_t closed = node.lanes() & ~visit.open;
    const Nearness found = nearness(Tag(), gaps, WideNode::kWidth, closed);
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
        state_.leaves.push_back({pair, 0, host_side, {kAtOnce, kAtOnce, kAtOnce, kAtOnce}});
        state_.leaves_deadlines.push_back(kAtOnce);
      } else {
        state_.visits.push_back({pair, 0});
        state_.visit_deadlines.push_back(kAtOnce);
      }
    }
  }

  /// Of a primitive of the host and these of the guest's leaf.
  HWY_INLINE Nearness nearness_of_row(std::uint32_t row, int host_side, std::uint32_t lanes) const {
    const FourTag tag;
    alignas(16) float gaps[4];
    for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
      const PairLanes<FourTag> pairs(4 * row + part);
      const PairBoxes<FourTag> boxes(pairs, host_leaf_, guest_leaf_);
      const PairTriangles<FourTag> triangles(pairs, host_leaf_, guest_leaf_);
      hn::Store(squared_gaps(tag, boxes, triangles, guest_leaf_.error, pass_.direction[host_side],
                             pass_.units[host_side]),
                tag, gaps + part);
    }
    set_roots(tag, gaps, gaps, 4);
    return nearness(tag, gaps, 4, lanes);
  }

  HWY_INLINE void compare_leaves(std::size_t index) {
    WideFront::Leaves& leaves = state_.leaves[index];
    const int host_side = leaves.host_side;
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
    const std::uint32_t count = ChildLink::count(host_link);
    const std::uint32_t guests = ChildLink::count(guest_link);
    set_host_leaf(host_leaf_, host, host_link);
    const std::uint32_t row_bits = (1u << guests) - 1;
    std::uint32_t near = 0;
    float soonest = kNever;
    for (std::uint32_t i = 0; i < count; ++i) {
      float& deadline = leaves.row_deadlines[i];
      if (deadline <= due_) {
        state_.counts.primitive_tests += guests;
        const std::uint32_t shift = ChildLink::kMaxLeafSize * i;
        const Nearness found = nearness_of_row(i, host_side, row_bits & ~(leaves.listed >> shift));
        near |= found.near << shift;
        deadline = deadline_after(found.least);
      }
      soonest = std::min(soonest, deadline);
    }
    state_.leaves_deadlines[index] = soonest;
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
  Promises promises_;
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

/// What has a deadline up to it is due.
float due_at(const WideFront::Pass& pass, double limit) {
  return rounded_up((pass.moved + limit) + 2 * pass.slack);
}

std::size_t count_due(const std::vector<float>& deadlines, float due) {
  return static_cast<std::size_t>(std::count_if(deadlines.begin(), deadlines.end(),
                                                [due](float deadline) { return deadline <= due; }));
}

}  // namespace

WideFront::Pass::Pass(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b, Bounds what,
                      double way)
    : bounds(what),
      moved(way),
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

void WideFront::begin(const WideTree& tree_a, const WideTree& tree_b) {
  state_.tree[0] = &tree_a;
  state_.tree[1] = &tree_b;
  state_.visits.assign(1, {{tree_a.root(), tree_b.root()}, 0});
  state_.visit_deadlines.assign(1, kAtOnce);
  state_.leaves.clear();
  state_.leaves_deadlines.clear();
  state_.candidates.clear();
  state_.candidate_deadlines.clear();
  state_.lanes = 0;
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
  leaves.row_deadlines[static_cast<std::size_t>(std::countr_zero(candidate.bit)) /
                       ChildLink::kMaxLeafSize] = kAtOnce;
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
