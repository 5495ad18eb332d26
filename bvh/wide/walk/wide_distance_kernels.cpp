// The walk over two wide trees in search of what is near, for each SIMD target that the compiler
// knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/walk/wide_distance_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <graze/bvh/wide/lanes/query_gaps-inl.h>
#include <graze/bvh/wide/walk/aligned_node-inl.h>
#include <graze/bvh/wide/walk/child_order-inl.h>
#include <graze/bvh/wide/walk/nearest_direction-inl.h>
#include <graze/bvh/wide/walk/wide_distance_walk.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

class Walker {
 public:
  Walker(WideDistanceWalk::State& state, std::span<BoundedPlaces> found, float limit,
         WideWalkCounts& counts)
      : state_(state),
        found_(found),
        limit_(std::min(limit, state.squared_upper_bound)),
        counts_(counts),
        scale_b_(static_cast<float>(state.into[0].scale)) {}

  std::size_t run() {
    do {
      while (!state_.open.empty() && size_ == 0) {
        const WideDistanceWalk::Waiting pair = state_.open.pop();
        if (pair.squared_bound > limit_) continue;
        if (is_for_later(pair.squared_bound)) {
          state_.later.push_back(pair);
        } else {
          compare(pair);
        }
      }
    } while (size_ == 0 && take_up_later());
    return size_;
  }

 private:
  bool is_for_later(float squared_bound) const {
    return squared_bound > limit_ * state_.squared_share;
  }

  /// Nothing is left for later from now on: boxes are opened, nearer ones first, and when these are
  /// done primitives are handed out. Whether there were any.
  bool take_up_later() {
    state_.squared_share = 1;
    if (state_.later.empty()) {
      hand_out_later();
      return size_ > 0;
    }
    std::erase_if(state_.later, [&](const auto& pair) { return pair.squared_bound > limit_; });
    // Keys are not negative, so that their bits have their order; and NaN has its place there.
    std::sort(state_.later.begin(), state_.later.end(), [](const auto& one, const auto& other) {
      return std::bit_cast<std::uint32_t>(one.key) > std::bit_cast<std::uint32_t>(other.key);
    });
    for (const WideDistanceWalk::Waiting& pair : state_.later)
      state_.open.push(pair);
    state_.later.clear();
    return true;
  }

  void hand_out_later() {
    std::vector<BoundedPlaces>& later = state_.later_places;
    for (; !later.empty() && size_ < WideDistanceWalk::kMostAtOnce; later.pop_back()) {
      if (!(later.back().squared_bound > limit_)) found_[size_++] = later.back();
    }
  }

  HWY_INLINE void compare(const WideDistanceWalk::Waiting& pair) {
    const std::uint32_t link_a = pair.a.node->child[pair.a.lane];
    const std::uint32_t link_b = pair.b.node->child[pair.b.lane];
    if (ChildLink::is_leaf(link_a) && ChildLink::is_leaf(link_b)) {
      const WideTree::Treelet& treelet_a = state_.tree[0]->treelet(pair.a.treelet);
      const WideTree::Treelet& treelet_b = state_.tree[1]->treelet(pair.b.treelet);
      set_query_along(0, treelet_b, link_b, treelet_a);
      compare_leaves(0, treelet_a, link_a, treelet_b, link_b);
      return;
    }
    const bool is_a_opened = is_first_opened(pair.a, link_a, pair.b, link_b, scale_b_);
    open_tested(is_a_opened ? 0 : 1, is_a_opened ? pair.a : pair.b, is_a_opened ? link_a : link_b,
                is_a_opened ? pair.b : pair.a, is_a_opened ? link_b : link_a);
  }

  HWY_INLINE void open_tested(int tested_side, const WideChildRef& tested,
                              std::uint32_t tested_link, const WideChildRef& query,
                              std::uint32_t query_link) {
    const TreeTransform& transform = state_.into[tested_side];
    const WideChildRef below =
        first_below(*state_.tree[tested_side], tested, tested_link, counts_.treelets);
    const WideNode& node = *below.node;
    counts_.box_tests += node.count;
    std::uint32_t near = node.lanes();
    const bool is_aligned = can_align();
    if (is_aligned) {
      set_aligned_bounds(aligned_bounds_, aligned(tested_side, below),
                         aligned(1 - tested_side, query), query.lane);
      near = not_beyond(near, aligned_bounds_, limit_);
      if (near == 0) {
        counts_.box_rejections += node.count;
        return;
      }
    }
    if (query_side_ != 1 - tested_side || query_child_ != query) {
      set_query(query_, *query.node, query.lane, transform);
      query_child_ = query;
      query_side_ = 1 - tested_side;
    }
    QueryInNode in_node;
    set_query_in_node(in_node, query_, node, transform.slack + kComparisonError * size_of(tested));
    if (is_aligned) {
      set_promises_beside(promises_, aligned_bounds_, node, in_node, state_.units[tested_side]);
    } else {
      set_promises(promises_, node, in_node,
                   aim_of(node, in_node, query_, state_.direction[tested_side]),
                   state_.units[tested_side]);
    }
    near = not_beyond(node.lanes(), promises_.bound, limit_);
    counts_.box_rejections += node.count - static_cast<std::uint32_t>(std::popcount(near));
    const auto child_with = [&](std::uint32_t lane) HWY_ATTR -> WideDistanceWalk::Waiting {
      const WideChildRef child = {&node, lane, below.treelet};
      return {tested_side == 0 ? child : query, tested_side == 0 ? query : child,
              promises_.bound[lane], promises_.key[lane]};
    };
    const std::uint32_t now = not_beyond(near, promises_.bound, limit_ * state_.squared_share);
    for (std::uint32_t rest = near & ~now; rest != 0; rest &= rest - 1)
      state_.later.push_back(child_with(static_cast<std::uint32_t>(std::countr_zero(rest))));
    near = now;
    if (ChildLink::is_leaf(query_link))
      near &= ~compare_leaves_below(tested_side, below, query, query_link, near);
    ChildOrder order(near, promises_.key);
    for (int count = std::popcount(near); count > 0; --count)
      state_.open.push(child_with(order.take_farthest()));
  }

  /// Compares the leaves among these children with the query box's leaf, nearer ones first: each
  /// may bring the limit down. Returns which they are.
  HWY_INLINE std::uint32_t compare_leaves_below(int tested_side, const WideChildRef& below,
                                                const WideChildRef& query, std::uint32_t query_link,
                                                std::uint32_t near) {
    const WideNode& node = *below.node;
    const std::uint32_t leaves = near & leaf_lanes(node);
    if (leaves == 0) return 0;
    const WideTree::Treelet& tested_treelet = state_.tree[tested_side]->treelet(below.treelet);
    const WideTree::Treelet& query_treelet = state_.tree[1 - tested_side]->treelet(query.treelet);
    set_query_along(tested_side, query_treelet, query_link, tested_treelet);
    for (std::uint32_t rest = leaves; rest != 0;) {
      const std::uint32_t lane = nearest(rest, promises_.key);
      rest &= ~(1u << lane);
      if (promises_.bound[lane] > limit_) continue;
      compare_leaves(tested_side, tested_treelet, node.child[lane], query_treelet, query_link);
    }
    return leaves;
  }

  /// Whether boxes are compared along shared axes: where a walk is soon over it does not pay.
  HWY_INLINE bool can_align() {
    if (state_.opened < WideDistanceWalk::kOpenedBefore) {
      ++state_.opened;
      return false;
    }
    if (state_.is_turned) state_.align();
    return state_.is_aligned;
  }

  HWY_INLINE const AlignedNode& aligned(int side, const WideChildRef& child) {
    AlignedNodes& nodes = state_.aligned[side];
    const std::size_t place = nodes.place_of(child.node);
    AlignedNode& boxes = nodes.boxes_at(place);
    if (nodes.node_at(place) != child.node) {
      set_aligned_node(boxes, *state_.tree[side], child, state_.aligned_transform[side]);
      nodes.node_at(place) = child.node;
    }
    return boxes;
  }

  HWY_INLINE void set_query_along(int tested_side, const WideTree::Treelet& query,
                                  std::uint32_t link, const WideTree::Treelet& tested) {
    set_query_leaf(query_leaf_, query, link, tested, state_.into[tested_side]);
    query_along_.set(query_leaf_, state_.direction[tested_side]);
  }

  HWY_INLINE void compare_leaves(int tested_side, const WideTree::Treelet& tested,
                                 std::uint32_t tested_link, const WideTree::Treelet& query,
                                 std::uint32_t query_link) {
    const std::uint32_t count = ChildLink::count(tested_link);
    const std::uint32_t queries = ChildLink::count(query_link);
    const std::uint32_t first = tested.first + ChildLink::first(tested_link);
    const std::uint32_t first_query = query.first + ChildLink::first(query_link);
    const float unit = state_.units[tested_side];
    const std::size_t begin = size_;
    set_tested_leaf(tested_leaf_, tested, tested_link);
    tested_along_.set(tested_leaf_, state_.direction[tested_side]);
    const std::uint32_t pairs = pairs_of(count, queries);
    counts_.primitive_tests += static_cast<std::uint32_t>(std::popcount(pairs));
    lower_limit_to(set_pairs(tested_side, pairs), unit);
    for (std::uint32_t near = near_pairs(pairs); near != 0; near &= near - 1) {
      const auto pair = static_cast<std::uint32_t>(std::countr_zero(near));
      const float bound = bounds_[pair] > 0 ? bounds_[pair] : 0;  // infinities may have made it NaN
      const std::uint32_t of_tested = pair / 4;
      const std::uint32_t of_query = pair % 4;
      const PlacePair places = tested_side == 0
                                   ? PlacePair{first + of_tested, first_query + of_query}
                                   : PlacePair{first_query + of_query, first + of_tested};
      found_[begin + near_.count] = {places, bound};
      near_.add(tested_leaf_, of_tested, query_leaf_, of_query);
    }
    if (near_.count > 0) look_closer(begin, unit);
  }

  /// Sets lower bounds of the squared distances of all pairs of the two leaves, and returns the
  /// squared distance of the nearest corners of those that are there and not beyond the limit.
  HWY_INLINE float set_pairs(int tested_side, std::uint32_t pairs) {
    const PairTag tag;
    const float error = query_leaf_.error;
    const float unit = state_.units[tested_side];
    auto least = hn::Set(tag, std::numeric_limits<float>::infinity());
    for (std::size_t part = 0; part < kLeafPairs; part += hn::Lanes(tag)) {
      const PairLanes<PairTag> lanes(part);
      const auto are_near = [&](hn::Vec<PairTag> bounds) HWY_ATTR {
        hn::Store(bounds, tag, bounds_ + part);
        const auto is_beyond = hn::Gt(bounds, hn::Set(tag, limit_));
        return pairs >> part & ~bits_of(tag, is_beyond) & ((1u << hn::Lanes(tag)) - 1);
      };
      const auto along = squared_gaps_along(tag, lanes, tested_along_, query_along_, error, unit);
      if (are_near(along) == 0) continue;
      const PairBoxes<PairTag> boxes(lanes, tested_leaf_, query_leaf_);
      const auto bounds = hn::Max(along, squared_box_gaps(tag, boxes, error, unit));
      const std::uint32_t near = are_near(bounds);
      if (near == 0) continue;
      const PairTriangles<PairTag> triangles(lanes, tested_leaf_, query_leaf_);
      hn::Store(hn::Max(bounds, squared_plane_gaps(tag, boxes, triangles, error, unit)), tag,
                bounds_ + part);
      const auto corners = squared_corners(tag, triangles);
      least = hn::IfThenElse(lanes_of(tag, near), hn::Min(least, corners), least);
    }
    return hn::GetLane(hn::MinOfLanes(tag, least));
  }

  /// Which of these pairs are not beyond the limit.
  HWY_INLINE std::uint32_t near_pairs(std::uint32_t pairs) {
    const PairTag tag;
    std::uint32_t beyond = 0;
    for (std::size_t part = 0; part < kLeafPairs; part += hn::Lanes(tag)) {
      const auto bounds = hn::Load(tag, bounds_ + part);
      beyond |= bits_of(tag, hn::Gt(bounds, hn::Set(tag, limit_))) << part;
    }
    return pairs & ~beyond;
  }

  /// Lowers the limit to how near the nearest points of the pairs are, and keeps the pairs that are
  /// not beyond it along the direction of these points either.
  HWY_INLINE void look_closer(std::size_t begin, float unit) {
    alignas(64) float bounds[NearPairs::kMost];
    lower_limit_to(set_bounds(bounds, near_, query_leaf_.error, unit), unit);
    for (std::uint32_t i = 0; i < near_.count; ++i) {
      BoundedPlaces pair = found_[begin + i];
      pair.squared_bound = std::max(pair.squared_bound, bounds[i]);
      if (pair.squared_bound > limit_) continue;
      if (is_for_later(pair.squared_bound)) {
        state_.later_places.push_back(pair);
      } else {
        found_[size_++] = pair;
      }
    }
    near_.count = 0;
  }

  /// Two points of primitives are so near, and nothing that is further apart is wanted. Each
  /// coordinate of their offset has the error of a difference of corners (nearest_direction-inl.h):
  /// the bound has four of these, and a millionth more for rounding.
  HWY_INLINE void lower_limit_to(float squared_offset, float unit) {
    if (!(unit > 0)) return;  // it is too small for a float to say how far that is
    // All squares overflowed. The least of infinities is the largest float on Highway's portable
    // target.
    if (!(squared_offset < std::numeric_limits<float>::max())) return;
    const float distance = (std::sqrt(squared_offset) + 4 * query_leaf_.error) * unit;
    const float bound = (distance * state_.growth + state_.margin) * (1 + 0x1p-20f);
    const float square = bound * bound * static_cast<float>(kBoundGrowth) + kWideUnderflow;
    if (square < state_.squared_upper_bound) state_.squared_upper_bound = square;
    if (square < limit_) limit_ = square;
  }

  WideDistanceWalk::State& state_;
  std::span<BoundedPlaces> found_;
  float limit_;
  WideWalkCounts& counts_;
  std::size_t size_ = 0;
  float scale_b_;
  Query query_{};
  WideChildRef query_child_{};  ///< whose box query_ is
  int query_side_ = -1;         ///< of its tree; -1 as long as there is none
  LeafLanes tested_leaf_;
  QueryLeaf query_leaf_;
  LeafAlong tested_along_;
  LeafAlong query_along_;
  alignas(64) float bounds_[kLeafPairs];
  NearPairs near_;
  Promises promises_;
  alignas(32) float aligned_bounds_[WideNode::kWidth];
};

std::size_t walk(WideDistanceWalk::State& state, std::span<BoundedPlaces> found, float limit,
                 WideWalkCounts& counts) {
  return Walker(state, found, limit, counts).run();
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(walk);

namespace {

/// What float bounds are compared with. Where it is more than a float can hold, so may bounds be
/// that are not beyond it: both are then infinite.
float float_limit(double squared_limit) {
  const double limit = squared_limit * kBoundGrowth;
  return limit < std::numeric_limits<float>::max() ? rounded_up(limit)
                                                   : std::numeric_limits<float>::infinity();
}

}  // namespace

WideDistanceWalk::State::State(const WideTree& tree_a, const WideTree& tree_b,
                               const RelativeFrame& of_b, const RelativeFrame& of_a,
                               const LengthMargins& margins)
    : tree{&tree_a, &tree_b},
      b_in_a(of_b),
      into{TreeTransform(of_b), TreeTransform(of_a)},
      units{static_cast<float>(of_b.units_a), static_cast<float>(of_a.units_a)},
      growth(rounded_up(margins.growth * margins.growth)),
      margin(rounded_up(2 * margins.margin * margins.growth)) {
  open.push({tree_a.root(), tree_b.root(), 0, 0});
}

void WideDistanceWalk::State::align() {
  is_turned = false;
  is_aligned = align_along(aligned_transform, b_in_a, aim, point);
  std::copy(aim, aim + 3, aligned_aim);
  for (AlignedNodes& nodes : aligned)
    nodes.clear();
}

WideDistanceWalk::WideDistanceWalk(const WideTree& tree_a, const WideTree& tree_b,
                                   const RelativeFrame& b_in_a, const RelativeFrame& a_in_b,
                                   const LengthMargins& margins)
    : state_(tree_a, tree_b, b_in_a, a_in_b, margins) {}

void WideDistanceWalk::aim_along(const double (&direction)[3], const double (&point)[3]) {
  const TreeTransform& of_a_in_b = state_.into[1];
  double turn = 0;
  for (int i = 0; i < 3; ++i) {
    state_.direction[0][i] = static_cast<float>(direction[i]);
    state_.direction[1][i] = static_cast<float>(-(of_a_in_b.rotation[i][0] * direction[0] +
                                                  of_a_in_b.rotation[i][1] * direction[1] +
                                                  of_a_in_b.rotation[i][2] * direction[2]));
    state_.aim[i] = direction[i];
    state_.point[i] = point[i];
    turn += direction[i] * state_.aligned_aim[i];
  }
  state_.is_turned = !(turn > kAligned);
}

void WideDistanceWalk::look_first_within(double share) {
  state_.squared_share = static_cast<float>(share * share);
  state_.later.reserve(kRoomForLater);
}

std::size_t WideDistanceWalk::next(std::span<BoundedPlaces> found, double squared_limit) {
  return HWY_DYNAMIC_DISPATCH(walk)(state_, found, float_limit(squared_limit), counts_);
}

bool WideDistanceWalk::is_beyond(const BoundedPlaces& pair, double squared_limit) const {
  return pair.squared_bound > std::min(state_.squared_upper_bound, float_limit(squared_limit));
}

}  // namespace graze::bvh
#endif
