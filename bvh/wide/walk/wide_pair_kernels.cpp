// The walk over two wide trees for each SIMD target that the compiler knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/walk/wide_pair_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/lanes/guest_node-inl.h>
#include <graze/bvh/wide/lanes/leaf_in_node-inl.h>
#include <graze/bvh/wide/lanes/slab_lanes-inl.h>
#include <graze/bvh/wide/lanes/slots-inl.h>
#include <graze/bvh/wide/walk/near_primitives-inl.h>
#include <graze/bvh/wide/walk/wide_pair_walk.h>
#include <hwy/highway.h>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// One of eight guests.
struct GuestAmongOthers {
  const GuestsInNode& in_node;
  std::uint32_t lane;

  HWY_INLINE float axis(int k, int i) const { return in_node.axes[k][i]; }
  HWY_INLINE float size(int k, int i) const { return in_node.size[k][i]; }
  HWY_INLINE float crossed(int k, int i) const { return in_node.crossed[k][i][lane]; }
  HWY_INLINE float way(int i) const { return in_node.way[i][lane]; }
  HWY_INLINE float reach(int i) const { return in_node.reach[i][lane]; }
  HWY_INLINE float half(int k) const { return in_node.half[k][lane]; }
};

/// The bits of the children that the guest is not proved apart from, and how far their middles are
/// from its own, squared.
template <typename AnyGuest>
HWY_INLINE std::uint32_t near_lanes(const WideNode& host, const AnyGuest& guest,
                                    float* squared_ways) {
  const Tag tag;
  std::uint32_t near = 0;
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    Lanes half[3], way[3];
    auto apart = hn::Gt(hn::Zero(tag), hn::Zero(tag));
    for (int i = 0; i < 3; ++i) {
      half[i] = hn::Load(tag, host.half[i] + lane);
      way[i] = hn::Sub(hn::Set(tag, guest.way(i)), hn::Load(tag, host.centre[i] + lane));
      apart =
          hn::Or(apart, hn::Gt(hn::Abs(way[i]), hn::Add(half[i], hn::Set(tag, guest.reach(i)))));
    }
    for (int k = 0; k < 3; ++k) {
      const Lanes distance =
          hn::MulAdd(way[0], hn::Set(tag, guest.axis(k, 0)),
                     hn::MulAdd(way[1], hn::Set(tag, guest.axis(k, 1)),
                                hn::Mul(way[2], hn::Set(tag, guest.axis(k, 2)))));
      const Lanes reach = hn::MulAdd(half[0], hn::Set(tag, guest.size(k, 0)),
                                     hn::MulAdd(half[1], hn::Set(tag, guest.size(k, 1)),
                                                hn::MulAdd(half[2], hn::Set(tag, guest.size(k, 2)),
                                                           hn::Set(tag, guest.half(k)))));
      apart = hn::Or(apart, hn::Gt(hn::Abs(distance), reach));
    }
    if (hn::AllTrue(tag, apart)) continue;
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        const Lanes distance = hn::MulSub(way[i2], hn::Set(tag, guest.axis(k, i1)),
                                          hn::Mul(way[i1], hn::Set(tag, guest.axis(k, i2))));
        const Lanes reach = hn::MulAdd(half[i1], hn::Set(tag, guest.size(k, i2)),
                                       hn::MulAdd(half[i2], hn::Set(tag, guest.size(k, i1)),
                                                  hn::Set(tag, guest.crossed(k, i))));
        apart = hn::Or(apart, hn::Gt(hn::Abs(distance), reach));
      }
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, hn::Not(apart), bits);
    near |= std::uint32_t{bits[0]} << lane;
    hn::Store(
        hn::Add(hn::Add(hn::Mul(way[0], way[0]), hn::Mul(way[1], way[1])), hn::Mul(way[2], way[2])),
        tag, squared_ways + lane);
  }
  return near & host.lanes();
}

/// Those of the children whose slabs do not prove that they are apart from the guest. Not inlined:
/// where nobody asks slabs the walk is faster without all this in its loop.
template <typename AnyGuest>
HWY_NOINLINE std::uint32_t near_slabs(const WideNode& host, const AnyGuest& guest,
                                      const GuestSlab& slab) {
  const Tag tag;
  std::uint32_t near = 0;
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    Lanes half[3], way[3];
    for (int i = 0; i < 3; ++i) {
      half[i] = hn::Load(tag, host.half[i] + lane);
      way[i] = hn::Sub(hn::Set(tag, guest.way(i)), hn::Load(tag, host.centre[i] + lane));
    }
    const SlabGap gap(SlabLanes(host, lane, half), way, guest, slab);
    const auto apart = hn::Gt(hn::Abs(gap.offset), gap.reach);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, hn::Not(apart), bits);
    near |= std::uint32_t{bits[0]} << lane;
  }
  return near;
}

/// The bits of the children that are leaves.
HWY_INLINE std::uint32_t leaf_lanes(const WideNode& node) {
  std::uint32_t lanes = 0;
  for (std::uint32_t lane = 0; lane < WideNode::kWidth; ++lane)
    lanes |= static_cast<std::uint32_t>(ChildLink::is_leaf(node.child[lane])) << lane;
  return lanes;
}

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

/// More children than these near one box, and something is likely to be hit soon: then the nearest
/// is followed before the others are looked at.
constexpr int kMostAtATime = 3;

/// One walk, from where it stopped to where it has found enough.
class Walker {
 public:
  Walker(WidePairWalk::State& state, std::span<PlacePair> found, WideWalkCounts& counts)
      : state_(state),
        found_(found),
        counts_(counts),
        scale_b_(static_cast<float>(state.into[0].scale)) {}

  std::size_t run() {
    while (!state_.open.empty() && size_ + WidePairWalk::kMostAtOnce <= found_.size()) {
      if (state_.steps_left != 0) look_elsewhere_in_time();
      compare(state_.open.pop());
    }
    return size_;
  }

 private:
  HWY_INLINE void look_elsewhere_in_time() {
    if (--state_.steps_left > 0) return;
    state_.patience *= 2;
    state_.steps_left = state_.patience;
    state_.open.swap_ends();
  }

  HWY_INLINE void compare(const WidePairWalk::Waiting& pair) {
    const std::uint32_t link_a = pair.a.node->child[pair.a.lane];
    const std::uint32_t link_b = pair.b.node->child[pair.b.lane];
    if (is_first_opened(pair.a, link_a, pair.b, link_b, scale_b_)) {
      open_host(0, pair.a, link_a, pair.b, link_b);
    } else {
      open_host(1, pair.b, link_b, pair.a, link_a);
    }
  }

  /// The children of one slot's node are tried against the other slot's box. Those near that are
  /// smaller than that box are what the children of its node are then tried against.
  HWY_INLINE void open_host(int host_side, const WideSlot& host, std::uint32_t host_link,
                            const WideSlot& guest, std::uint32_t guest_link) {
    const WideWay& way = state_.into[host_side];
    set_guest(guest_, *guest.node, guest.lane, way);
    const WideSlot below = first_below(*state_.tree[host_side], host, host_link, counts_.treelets);
    const WideNode& node = *below.node;
    set_guest_in_node(in_node_, guest_, node, way.slack + kComparisonError * size_of(host));
    std::uint32_t near = near_lanes(node, OneGuest{in_node_}, squared_ways_);
    if (near != 0 && node.has_slabs && guest.node->has_slabs) {
      near &= near_slabs(
          node, OneGuest{in_node_},
          slab_of(*guest.node, guest.lane, static_cast<float>(way.scale), in_node_.padding));
    }
    count(node, near);
    if (near == 0) return;
    if (ChildLink::is_leaf(guest_link)) {
      push_or_compare(host_side, below, near, squared_ways_, guest, guest_link);
      return;
    }
    const std::uint32_t next =
        near &
        (leaf_lanes(node) | smaller_lanes(node, size_of(guest) * static_cast<float>(way.scale)));
    for (std::uint32_t rest = near & ~next; rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(rest));
      push(host_side, {&node, lane, below.treelet}, guest);
    }
    if (next != 0) open_guest(1 - host_side, guest, guest_link, host, below, next);
  }

  /// The same the other way round, for some children at once, which lie in the slot `above`.
  HWY_INLINE void open_guest(int host_side, const WideSlot& host, std::uint32_t host_link,
                             const WideSlot& above, const WideSlot& guests, std::uint32_t lanes) {
    const WideWay& way = state_.into[host_side];
    const WideSlot below = first_below(*state_.tree[host_side], host, host_link, counts_.treelets);
    const WideNode& node = *below.node;
    const float sizes = size_of(host) + 2 * size_of(above) * static_cast<float>(way.scale);
    const float padding = way.slack + kComparisonError * sizes;
    set_guests_in_node(guests_in_node_, *guests.node, node, way, padding);
    const bool are_slabs_asked = node.has_slabs && guests.node->has_slabs;
    const bool are_many = std::popcount(lanes) > kMostAtATime;
    alignas(32) float squared_ways[WideNode::kWidth];
    while (lanes != 0 && size_ + WidePairWalk::kMostAtOnce <= found_.size()) {
      const std::uint32_t lane =
          are_many ? nearest(lanes, squared_ways_) : farthest(lanes, squared_ways_);
      lanes &= ~(1u << lane);
      const GuestAmongOthers other{guests_in_node_, lane};
      std::uint32_t near = near_lanes(node, other, squared_ways);
      if (near != 0 && are_slabs_asked) {
        near &= near_slabs(node, other,
                           slab_of(*guests.node, lane, static_cast<float>(way.scale), padding));
      }
      count(node, near);
      if (are_many && near != 0) {
        push_all(1 - host_side, guests, lanes, host);
        lanes = 0;
      }
      push_or_compare(host_side, below, near, squared_ways, {guests.node, lane, guests.treelet},
                      guests.node->child[lane]);
    }
    push_all(1 - host_side, guests, lanes, host);
  }

  /// What of a host's children is near a guest: leaves are compared with leaves at once. Several
  /// children near one leaf are first tried against its primitives one by one: where these are
  /// large beside the children, much of the leaf's box is empty.
  HWY_INLINE void push_or_compare(int host_side, const WideSlot& below, std::uint32_t near,
                                  const float* squared_ways, const WideSlot& guest,
                                  std::uint32_t guest_link) {
    const bool is_guest_leaf = ChildLink::is_leaf(guest_link);
    bool is_guest_leaf_set = false;
    if (is_guest_leaf && std::popcount(near) > 1) {
      set_guest_leaf(guest_leaf_, state_.tree[1 - host_side]->treelet(guest.treelet), guest_link,
                     state_.tree[host_side]->treelet(below.treelet), state_.into[host_side]);
      is_guest_leaf_set = true;
      set_leaf_in_node(leaf_in_node_, guest_leaf_, *below.node,
                       state_.tree[host_side]->treelet(below.treelet).origin);
      near &= near_primitives_of(leaf_in_node_, ChildLink::count(guest_link), *below.node);
    }
    while (near != 0) {
      const std::uint32_t lane = farthest(near, squared_ways);
      near &= ~(1u << lane);
      const std::uint32_t link = below.node->child[lane];
      if (is_guest_leaf && ChildLink::is_leaf(link)) {
        const WideTree::Treelet& host_treelet = state_.tree[host_side]->treelet(below.treelet);
        const WideTree::Treelet& guest_treelet = state_.tree[1 - host_side]->treelet(guest.treelet);
        if (!is_guest_leaf_set)
          set_guest_leaf(guest_leaf_, guest_treelet, guest_link, host_treelet,
                         state_.into[host_side]);
        is_guest_leaf_set = true;
        compare_leaves(host_side, host_treelet, link, guest_treelet, guest_link);
        continue;
      }
      push(host_side, {below.node, lane, below.treelet}, guest);
    }
  }

  HWY_INLINE void push(int side, const WideSlot& slot, const WideSlot& other) {
    state_.open.push(side == 0 ? WidePairWalk::Waiting{slot, other}
                               : WidePairWalk::Waiting{other, slot});
  }

  /// Children of one node, the nearest last.
  HWY_INLINE void push_all(int side, const WideSlot& first, std::uint32_t lanes,
                           const WideSlot& other) {
    while (lanes != 0) {
      const std::uint32_t lane = farthest(lanes, squared_ways_);
      lanes &= ~(1u << lane);
      push(side, {first.node, lane, first.treelet}, other);
    }
  }

  HWY_INLINE void count(const WideNode& node, std::uint32_t near) {
    counts_.box_tests += node.count;
    counts_.box_rejections += node.count - static_cast<std::uint32_t>(std::popcount(near));
  }

  HWY_INLINE void compare_leaves(int host_side, const WideTree::Treelet& host,
                                 std::uint32_t host_link, const WideTree::Treelet& guest,
                                 std::uint32_t guest_link) {
    const std::uint32_t first = host.first + ChildLink::first(host_link);
    const std::uint32_t first_guest = guest.first + ChildLink::first(guest_link);
    counts_.primitive_tests += ChildLink::count(host_link) * ChildLink::count(guest_link);
    set_host_leaf(host_leaf_, host, host_link);
    std::uint32_t near = near_primitives(host_leaf_, guest_leaf_) &
                         pairs_of(ChildLink::count(host_link), ChildLink::count(guest_link));
    for (; near != 0; near &= near - 1) {
      const auto pair = static_cast<std::uint32_t>(std::countr_zero(near));
      const std::uint32_t place = first + pair / 4;
      const std::uint32_t place_of_guest = first_guest + pair % 4;
      found_[size_++] =
          host_side == 0 ? PlacePair{place, place_of_guest} : PlacePair{place_of_guest, place};
    }
  }

  WidePairWalk::State& state_;
  std::span<PlacePair> found_;
  WideWalkCounts& counts_;
  std::size_t size_ = 0;
  float scale_b_;
  Guest guest_{};
  GuestInNode in_node_;
  GuestsInNode guests_in_node_;
  LeafLanes host_leaf_;
  GuestLeaf guest_leaf_;
  LeafInNode leaf_in_node_;
  alignas(32) float squared_ways_[WideNode::kWidth];
};

std::size_t walk(WidePairWalk::State& state, std::span<PlacePair> found, WideWalkCounts& counts) {
  return Walker(state, found, counts).run();
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(walk);

WidePairWalk::WidePairWalk(const WideTree& tree_a, const WideTree& tree_b,
                           const RelativeFrame& b_in_a, const RelativeFrame& a_in_b)
    : state_(tree_a, tree_b, b_in_a, a_in_b) {
  state_.open.push({tree_a.root(), tree_b.root()});
}

std::size_t WidePairWalk::next(std::span<PlacePair> found) {
  return HWY_DYNAMIC_DISPATCH(walk)(state_, found, counts_);
}

}  // namespace graze::bvh
#endif
