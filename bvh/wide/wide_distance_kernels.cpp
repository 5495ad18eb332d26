// The walk over two wide trees in search of what is near, for each SIMD target that the compiler
// knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/wide_distance_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/wide_distance_walk.h>
#include <hwy/highway.h>
#include <graze/bvh/wide/guest_leaf.inc>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// A direction along the axes of a host node, and how far a guest reaches along it.
struct Aim {
  float axes[3];
  float size[3];
  float reach;
};

HWY_INLINE Aim aim_of(const WideNode& host, const GuestInNode& guest, const Guest& box,
                      const float (&direction)[3]) {
  Aim aim;
  for (int i = 0; i < 3; ++i) {
    aim.axes[i] = host.axes[0][i] * direction[0] + host.axes[1][i] * direction[1] +
                  host.axes[2][i] * direction[2];
    aim.size[i] = std::abs(aim.axes[i]);
  }
  aim.reach = guest.half[0] - box.half[0];  // the margins alone
  for (int k = 0; k < 3; ++k) {
    aim.reach +=
        box.half[k] * std::abs(guest.axes[k][0] * aim.axes[0] + guest.axes[k][1] * aim.axes[1] +
                               guest.axes[k][2] * aim.axes[2]);
  }
  return aim;
}

/// What the children of a host promise of a guest: lanes of squares.
struct Promises {
  alignas(32) float bound[WideNode::kWidth];  // of their distance, from below
  alignas(32) float key[WideNode::kWidth];    // what to look at first: less is nearer
};

// Middles tell where bounds do not.
constexpr float kMiddleWeight = 0.1f;

/// A gap as far as it is known: one that is negative is none, and so is what overflowed.
template <typename Tag>
HWY_INLINE hn::Vec<Tag> known(Tag tag, hn::Vec<Tag> gap) {
  const auto infinity = hn::Set(tag, std::numeric_limits<float>::infinity());
  const auto is_known = hn::And(hn::Gt(gap, hn::Zero(tag)), hn::Lt(gap, infinity));
  return hn::IfThenElseZero(is_known, gap);
}

// Squares are taken in common units, the larger of both trees': what overflows then is far.
HWY_INLINE Lanes squared_gap(Lanes offset, Lanes reach, Lanes unit) {
  const Lanes gap = hn::Mul(known(Tag(), hn::Sub(hn::Abs(offset), reach)), unit);
  return hn::Mul(gap, gap);
}

// In the axes of the host the way between two points has components of at least the gaps between a
// host's box and the box around the guest along these axes; so has it in the axes of the guest,
// with the roles exchanged. Each triple of gaps, squared and summed, is a lower bound.
HWY_INLINE void set_promises(Promises& promises, const WideNode& host, const GuestInNode& guest,
                             const Aim& aim, float unit_of_host) {
  const Tag tag;
  const Lanes unit = hn::Set(tag, unit_of_host);
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    Lanes half[3], way[3];
    Lanes in_host = hn::Zero(tag);
    Lanes in_guest = in_host;
    Lanes middles = in_host;
    Lanes along = in_host;
    Lanes reach_along = hn::Set(tag, aim.reach);
    for (int i = 0; i < 3; ++i) {
      half[i] = hn::Load(tag, host.half[i] + lane);
      way[i] = hn::Sub(hn::Set(tag, guest.way[i]), hn::Load(tag, host.centre[i] + lane));
      in_host = hn::Add(in_host,
                        squared_gap(way[i], hn::Add(half[i], hn::Set(tag, guest.reach[i])), unit));
      const Lanes step = hn::Mul(way[i], unit);
      middles = hn::MulAdd(step, step, middles);
      along = hn::MulAdd(way[i], hn::Set(tag, aim.axes[i]), along);
      reach_along = hn::MulAdd(half[i], hn::Set(tag, aim.size[i]), reach_along);
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
      in_guest = hn::Add(in_guest, squared_gap(distance, reach, unit));
    }
    const Lanes gap = hn::Mul(known(tag, hn::Sub(along, reach_along)), unit);
    const Lanes bound = hn::Max(hn::Max(in_host, in_guest), hn::Mul(gap, gap));
    hn::Store(bound, tag, promises.bound + lane);
    hn::Store(hn::MulAdd(middles, hn::Set(tag, kMiddleWeight), bound), tag, promises.key + lane);
  }
}

/// How far three corners are beyond a plane, at least, if they are on one side of it.
template <typename CornerOf>
HWY_INLINE Four beyond_plane(const Four* normal, const Four* point, CornerOf&& corner_of,
                             Four bound) {
  const FourTag tag;
  Four low = hn::Zero(tag);
  Four high = low;
  for (int c = 0; c < 3; ++c) {
    const Four height =
        hn::MulAdd(normal[0], hn::Sub(corner_of(c, 0), point[0]),
                   hn::MulAdd(normal[1], hn::Sub(corner_of(c, 1), point[1]),
                              hn::Mul(normal[2], hn::Sub(corner_of(c, 2), point[2]))));
    low = c == 0 ? height : hn::Min(low, height);
    high = c == 0 ? height : hn::Max(high, height);
  }
  const Four gap = known(tag, hn::Sub(hn::Max(low, hn::Neg(high)), bound));
  const Four square = hn::MulAdd(normal[0], normal[0],
                                 hn::MulAdd(normal[1], normal[1], hn::Mul(normal[2], normal[2])));
  // No plane, no gap: a normal that vanishes is shorter than what is added.
  return hn::Div(gap, hn::Sqrt(hn::Add(square, hn::Set(tag, kWideUnderflow))));
}

HWY_INLINE float along(const float (&direction)[3], const float (&p)[3]) {
  return direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2];
}

/// Lower bounds of the squared distances of a host's primitive and the guest's: along a direction,
/// by boxes along the axes of the host's tree, and by the planes of both.
HWY_INLINE void set_bounds(float* bounds, const HostTriangle& host, const GuestLeaf& guest,
                           const float (&direction)[3], float unit_of_host) {
  const FourTag tag;
  const Four unit = hn::Set(tag, unit_of_host);
  const float end =
      std::max(std::max(along(direction, host.corner[0]), along(direction, host.corner[1])),
               along(direction, host.corner[2]));
  const Four error = hn::Set(tag, guest.error);
  for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
    Four of_boxes = hn::Zero(tag);
    Four extent = of_boxes;
    for (int i = 0; i < 3; ++i) {
      const Four low = hn::Load(tag, guest.low[i] + part);
      const Four high = hn::Load(tag, guest.high[i] + part);
      const Four host_low = hn::Set(tag, host.low[i]);
      const Four host_high = hn::Set(tag, host.high[i]);
      const Four gap =
          known(tag, hn::Sub(hn::Max(hn::Sub(low, host_high), hn::Sub(host_low, high)), error));
      const Four step = hn::Mul(gap, unit);
      of_boxes = hn::MulAdd(step, step, of_boxes);
      extent = hn::Max(extent, hn::Sub(hn::Max(high, host_high), hn::Min(low, host_low)));
    }
    const Four bound = height_error(extent, error);
    Four normal[3], point[3];
    for (int i = 0; i < 3; ++i) {
      normal[i] = hn::Set(tag, host.normal[i]);
      point[i] = hn::Set(tag, host.corner[0][i]);
    }
    const Four of_host = beyond_plane(
        normal, point,
        [&](int c, int i) HWY_ATTR { return hn::Load(tag, guest.corner[c][i] + part); }, bound);
    for (int i = 0; i < 3; ++i) {
      normal[i] = hn::Load(tag, guest.normal[i] + part);
      point[i] = hn::Load(tag, guest.corner[0][i] + part);
    }
    const Four of_guest = beyond_plane(
        normal, point, [&](int c, int i) HWY_ATTR { return hn::Set(tag, host.corner[c][i]); },
        bound);
    Four start = hn::Set(tag, std::numeric_limits<float>::infinity());
    for (int c = 0; c < 3; ++c) {
      Four corner = hn::Zero(tag);
      for (int i = 0; i < 3; ++i) {
        corner = hn::MulAdd(hn::Load(tag, guest.corner[c][i] + part), hn::Set(tag, direction[i]),
                            corner);
      }
      start = hn::Min(start, corner);
    }
    // Along a unit vector an error in each of three coordinates counts 1.74 times, that of the
    // products once more.
    const Four gap =
        known(tag, hn::Sub(hn::Sub(start, hn::Set(tag, end)), hn::Mul(error, hn::Set(tag, 4.0f))));
    const Four step = hn::Mul(hn::Max(gap, hn::Max(of_host, of_guest)), unit);
    hn::Store(hn::Max(of_boxes, hn::Mul(step, step)), tag, bounds + part);
  }
}

/// The squared distances of the nearest corners of a host's primitive and the guest's.
HWY_INLINE void set_squared_corners(float* squares, const HostTriangle& host,
                                    const GuestLeaf& guest) {
  const FourTag tag;
  for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
    Four least = hn::Set(tag, std::numeric_limits<float>::infinity());
    for (int c = 0; c < 3; ++c) {
      const Four x = hn::Load(tag, guest.corner[c][0] + part);
      const Four y = hn::Load(tag, guest.corner[c][1] + part);
      const Four z = hn::Load(tag, guest.corner[c][2] + part);
      for (int d = 0; d < 3; ++d) {
        const Four dx = hn::Sub(x, hn::Set(tag, host.corner[d][0]));
        const Four dy = hn::Sub(y, hn::Set(tag, host.corner[d][1]));
        const Four dz = hn::Sub(z, hn::Set(tag, host.corner[d][2]));
        least = hn::Min(least, hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz))));
      }
    }
    hn::Store(least, tag, squares + part);
  }
}

HWY_INLINE float size_of(const WideSlot& slot) {
  const WideNode& node = *slot.node;
  return node.half[0][slot.lane] + node.half[1][slot.lane] + node.half[2][slot.lane];
}

class Walker {
 public:
  Walker(WideDistanceWalk::State& state, std::span<BoundedPlaces> found, float limit,
         WideWalkCounts& counts)
      : state_(state),
        found_(found),
        limit_(std::min(limit, state.squared_reach)),
        counts_(counts),
        scale_b_(static_cast<float>(state.into[0].scale)) {}

  std::size_t run() {
    while (!state_.open.empty() && size_ == 0) {
      const WideDistanceWalk::Waiting pair = state_.open.pop();
      if (!(pair.squared_bound > limit_)) compare(pair);
    }
    return size_;
  }

 private:
  HWY_INLINE void compare(const WideDistanceWalk::Waiting& pair) {
    const std::uint32_t link_a = pair.a.node->child[pair.a.lane];
    const std::uint32_t link_b = pair.b.node->child[pair.b.lane];
    if (ChildLink::is_leaf(link_b) ||
        (!ChildLink::is_leaf(link_a) && size_of(pair.a) >= size_of(pair.b) * scale_b_)) {
      open_host(0, pair.a, link_a, pair.b, link_b);
    } else {
      open_host(1, pair.b, link_b, pair.a, link_a);
    }
  }

  HWY_INLINE void open_host(int host_side, const WideSlot& host, std::uint32_t host_link,
                            const WideSlot& guest, std::uint32_t guest_link) {
    const WideWay& way = state_.into[host_side];
    if (guest_side_ != 1 - host_side || guest_slot_ != guest) {
      set_guest(guest_, *guest.node, guest.lane, way);
      guest_slot_ = guest;
      guest_side_ = 1 - host_side;
    }
    const WideSlot below = first_below(host_side, host, host_link);
    const WideNode& node = *below.node;
    set_guest_in_node(in_node_, guest_, node, way.slack + kComparisonError * size_of(host));
    set_promises(promises_, node, in_node_,
                 aim_of(node, in_node_, guest_, state_.direction[host_side]),
                 state_.units[host_side]);
    std::uint32_t near = 0;
    for (std::uint32_t lane = 0; lane < node.count; ++lane)
      near |= static_cast<std::uint32_t>(!(promises_.bound[lane] > limit_)) << lane;
    counts_.box_tests += node.count;
    counts_.box_rejections += node.count - static_cast<std::uint32_t>(std::popcount(near));
    bool is_guest_leaf_set = false;
    while (near != 0) {
      const std::uint32_t lane = farthest(near);
      near &= ~(1u << lane);
      const std::uint32_t link = node.child[lane];
      if (ChildLink::is_leaf(guest_link) && ChildLink::is_leaf(link)) {
        const WideTree::Treelet& host_treelet = state_.tree[host_side]->treelet(below.treelet);
        const WideTree::Treelet& guest_treelet = state_.tree[1 - host_side]->treelet(guest.treelet);
        if (!is_guest_leaf_set)
          set_guest_leaf(guest_leaf_, guest_treelet, guest_link, host_treelet, way);
        is_guest_leaf_set = true;
        compare_leaves(host_side, host_treelet, link, guest_treelet, guest_link);
        continue;
      }
      const WideSlot child = {&node, lane, below.treelet};
      state_.open.push(
          {host_side == 0 ? child : guest, host_side == 0 ? guest : child, promises_.bound[lane]});
    }
  }

  /// The first lane of the node that a link leads to.
  HWY_INLINE WideSlot first_below(int side, const WideSlot& slot, std::uint32_t link) {
    const std::uint32_t index = ChildLink::index(link);
    if (!ChildLink::is_treelet(link)) return {slot.node + index, 0, slot.treelet};
    return {state_.tree[side]->entered(index, counts_.treelets).nodes.data(), 0, index};
  }

  /// Of these lanes. What is pushed last is looked at first: the nearest.
  HWY_INLINE std::uint32_t farthest(std::uint32_t lanes) const {
    auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
    for (std::uint32_t rest = lanes & (lanes - 1); rest != 0; rest &= rest - 1) {
      const auto other = static_cast<std::uint32_t>(std::countr_zero(rest));
      if (promises_.key[other] > promises_.key[lane]) lane = other;
    }
    return lane;
  }

  HWY_INLINE void compare_leaves(int host_side, const WideTree::Treelet& host,
                                 std::uint32_t host_link, const WideTree::Treelet& guest,
                                 std::uint32_t guest_link) {
    const std::uint32_t count = ChildLink::count(host_link);
    const std::uint32_t guests = ChildLink::count(guest_link);
    const std::uint32_t first = host.first + ChildLink::first(host_link);
    const std::uint32_t first_guest = guest.first + ChildLink::first(guest_link);
    const float* rows = host.corners.data() + CornerRows::kRows * ChildLink::first(host_link);
    counts_.primitive_tests += count * guests;
    const float unit = state_.units[host_side];
    for (std::uint32_t i = 0; i < count; ++i) {
      const HostTriangle triangle(rows, count, i);
      alignas(16) float bounds[4];
      alignas(16) float corners[4];
      set_bounds(bounds, triangle, guest_leaf_, state_.direction[host_side], unit);
      set_squared_corners(corners, triangle, guest_leaf_);
      for (std::uint32_t j = 0; j < guests; ++j) {
        const float bound = bounds[j] > 0 ? bounds[j] : 0;  // infinities may have made it NaN
        if (bound > limit_) continue;
        reach_to(corners[j], unit);
        const PlacePair places = host_side == 0 ? PlacePair{first + i, first_guest + j}
                                                : PlacePair{first_guest + j, first + i};
        found_[size_++] = {places, bound};
      }
    }
  }

  /// Two corners are as near: nothing that is further apart is wanted. Twice the error of a
  /// corner's coordinates in each direction, and a thousandth of a thousandth for rounding.
  HWY_INLINE void reach_to(float squared_corners, float unit) {
    if (!(unit > 0)) return;  // it is too small for a float to say how far that is
    const float distance = (std::sqrt(squared_corners) + 4 * guest_leaf_.error) * unit;
    const float reach = (distance * state_.growth + state_.margin) * (1 + 0x1p-20f);
    const float square = reach * reach * static_cast<float>(kBoundGrowth) + kWideUnderflow;
    if (square < state_.squared_reach) state_.squared_reach = square;
    if (square < limit_) limit_ = square;
  }

  WideDistanceWalk::State& state_;
  std::span<BoundedPlaces> found_;
  float limit_;
  WideWalkCounts& counts_;
  std::size_t size_ = 0;
  float scale_b_;
  Guest guest_{};
  WideSlot guest_slot_{};  // of guest_, in the tree of
  int guest_side_ = -1;    // this side, if of any
  GuestInNode in_node_;
  GuestLeaf guest_leaf_;
  Promises promises_;
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

WideDistanceWalk::WideDistanceWalk(const WideTree& tree_a, const WideTree& tree_b,
                                   const RelativeFrame& b_in_a, const RelativeFrame& a_in_b,
                                   const LengthMargins& margins)
    : state_{{&tree_a, &tree_b},
             {WideWay(b_in_a), WideWay(a_in_b)},
             {static_cast<float>(b_in_a.units_a), static_cast<float>(a_in_b.units_a)},
             rounded_up(margins.growth * margins.growth),
             rounded_up(2 * margins.margin * margins.growth),
             {},
             std::numeric_limits<float>::infinity(),
             {}} {
  state_.open.push({tree_a.root(), tree_b.root(), 0});
}

void WideDistanceWalk::aim_along(const double (&direction)[3]) {
  const WideWay& of_a_in_b = state_.into[1];
  for (int i = 0; i < 3; ++i) {
    state_.direction[0][i] = static_cast<float>(direction[i]);
    state_.direction[1][i] = static_cast<float>(-(of_a_in_b.rotation[i][0] * direction[0] +
                                                  of_a_in_b.rotation[i][1] * direction[1] +
                                                  of_a_in_b.rotation[i][2] * direction[2]));
  }
}

std::size_t WideDistanceWalk::next(std::span<BoundedPlaces> found, double squared_limit) {
  return HWY_DYNAMIC_DISPATCH(walk)(state_, found, float_limit(squared_limit), counts_);
}

bool WideDistanceWalk::is_beyond(const BoundedPlaces& pair, double squared_limit) const {
  return pair.squared_bound > std::min(state_.squared_reach, float_limit(squared_limit));
}

}  // namespace graze::bvh
#endif
