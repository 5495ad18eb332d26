// The walk over two wide trees for each SIMD target that the compiler knows.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/wide/wide_pair_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/wide/wide_pair_walk.h>
#include <hwy/cache_control.h>
#include <hwy/highway.h>
#include <graze/bvh/wide/guest_leaf.inc>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// The bits of the children that the guest is not proved apart from, and how far their middles are
/// from its own, squared.
HWY_INLINE std::uint32_t near_lanes(const WideNode& host, const GuestInNode& guest,
                                    float* squared_ways) {
  const Tag tag;
  std::uint32_t near = 0;
  for (std::size_t lane = 0; lane < WideNode::kWidth; lane += hn::Lanes(tag)) {
    Lanes half[3], way[3];
    auto apart = hn::Gt(hn::Zero(tag), hn::Zero(tag));
    for (int i = 0; i < 3; ++i) {
      half[i] = hn::Load(tag, host.half[i] + lane);
      way[i] = hn::Sub(hn::Set(tag, guest.way[i]), hn::Load(tag, host.centre[i] + lane));
      apart =
          hn::Or(apart, hn::Gt(hn::Abs(way[i]), hn::Add(half[i], hn::Set(tag, guest.reach[i]))));
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
      apart = hn::Or(apart, hn::Gt(hn::Abs(distance), reach));
    }
    if (hn::AllTrue(tag, apart)) continue;
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        const Lanes distance = hn::MulSub(way[i2], hn::Set(tag, guest.axes[k][i1]),
                                          hn::Mul(way[i1], hn::Set(tag, guest.axes[k][i2])));
        const Lanes reach = hn::MulAdd(half[i1], hn::Set(tag, guest.size[k][i2]),
                                       hn::MulAdd(half[i2], hn::Set(tag, guest.size[k][i1]),
                                                  hn::Set(tag, guest.crossed[k][i])));
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

HWY_INLINE float size_of(const WideSlot& slot) {
  const WideNode& node = *slot.node;
  return node.half[0][slot.lane] + node.half[1][slot.lane] + node.half[2][slot.lane];
}

/// Asks for the memory of a node that is looked at soon.
HWY_INLINE void fetch_ahead(const WideNode& node) {
  constexpr std::size_t kLine = 64;  // bytes
  for (std::size_t offset = 0; offset < sizeof(WideNode) + kLine; offset += kLine)
    hwy::Prefetch(reinterpret_cast<const char*>(&node) + offset);
}

/// One walk, from where it stopped to where it has found enough.
class Walker {
 public:
  Walker(WidePairWalk::State& state, std::span<PlacePair> found, WideWalkCounts& counts)
      : state_(state),
        found_(found),
        counts_(counts),
        scale_b_(static_cast<float>(state.into[0].scale)) {}

  std::size_t run() {
    while (!state_.open.empty() && size_ + WidePairWalk::kMostAtOnce <= found_.size())
      compare(state_.open.pop());
    return size_;
  }

  std::size_t run_one() {
    compare(state_.open.pop());
    return size_;
  }

 private:
  HWY_INLINE void compare(const WidePairWalk::Waiting& pair) {
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
    std::uint32_t near = near_lanes(node, in_node_, squared_ways_);
    counts_.box_tests += node.count;
    counts_.box_rejections += node.count - static_cast<std::uint32_t>(std::popcount(near));
    const bool is_guest_leaf = ChildLink::is_leaf(guest_link);
    bool is_guest_leaf_set = false;
    while (near != 0) {
      const std::uint32_t lane = farthest(near);
      near &= ~(1u << lane);
      const std::uint32_t link = node.child[lane];
      if (is_guest_leaf && ChildLink::is_leaf(link)) {
        const WideTree::Treelet& host_treelet = state_.tree[host_side]->treelet(below.treelet);
        const WideTree::Treelet& guest_treelet = state_.tree[1 - host_side]->treelet(guest.treelet);
        if (!is_guest_leaf_set)
          set_guest_leaf(guest_leaf_, guest_treelet, guest_link, host_treelet, way);
        is_guest_leaf_set = true;
        compare_leaves(host_side, host_treelet, link, guest_treelet, guest_link);
        continue;
      }
      if (ChildLink::is_node(link)) fetch_ahead((&node)[ChildLink::index(link)]);
      const WideSlot child = {&node, lane, below.treelet};
      state_.open.push(host_side == 0 ? WidePairWalk::Waiting{child, guest}
                                      : WidePairWalk::Waiting{guest, child});
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
      if (squared_ways_[other] > squared_ways_[lane]) lane = other;
    }
    return lane;
  }

  HWY_INLINE void compare_leaves(int host_side, const WideTree::Treelet& host,
                                 std::uint32_t host_link, const WideTree::Treelet& guest,
                                 std::uint32_t guest_link) {
    const std::uint32_t count = ChildLink::count(host_link);
    const std::uint32_t first = host.first + ChildLink::first(host_link);
    const std::uint32_t first_guest = guest.first + ChildLink::first(guest_link);
    const std::uint32_t guests = (1u << ChildLink::count(guest_link)) - 1;
    const float* rows = host.corners.data() + CornerRows::kRows * ChildLink::first(host_link);
    counts_.primitive_tests += count * ChildLink::count(guest_link);
    for (std::uint32_t i = 0; i < count; ++i) {
      std::uint32_t near = near_primitives(HostTriangle(rows, count, i), guest_leaf_) & guests;
      for (; near != 0; near &= near - 1) {
        const std::uint32_t place =
            first_guest + static_cast<std::uint32_t>(std::countr_zero(near));
        found_[size_++] =
            host_side == 0 ? PlacePair{first + i, place} : PlacePair{place, first + i};
      }
    }
  }

  WidePairWalk::State& state_;
  std::span<PlacePair> found_;
  WideWalkCounts& counts_;
  std::size_t size_ = 0;
  float scale_b_;
  Guest guest_{};
  WideSlot guest_slot_{};  // of guest_, in the tree of
  int guest_side_ = -1;    // this side, if of any
  GuestInNode in_node_;
  GuestLeaf guest_leaf_;
  alignas(32) float squared_ways_[WideNode::kWidth];
};

std::size_t walk(WidePairWalk::State& state, std::span<PlacePair> found, WideWalkCounts& counts) {
  return Walker(state, found, counts).run();
}

std::size_t open_one(WidePairWalk::State& state, std::span<PlacePair> found,
                     WideWalkCounts& counts) {
  return Walker(state, found, counts).run_one();
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(walk);
HWY_EXPORT(open_one);

WidePairWalk::WidePairWalk(const WideTree& tree_a, const WideTree& tree_b,
                           const RelativeFrame& b_in_a, const RelativeFrame& a_in_b)
    : state_{{&tree_a, &tree_b}, {WideWay(b_in_a), WideWay(a_in_b)}, {}} {
  state_.open.push({tree_a.root(), tree_b.root()});
}

std::size_t WidePairWalk::next(std::span<PlacePair> found) {
  return HWY_DYNAMIC_DISPATCH(walk)(state_, found, counts_);
}

std::size_t WidePairWalk::open_one(std::span<PlacePair> found, std::vector<Waiting>& waiting) {
  const std::size_t count = HWY_DYNAMIC_DISPATCH(open_one)(state_, found, counts_);
  while (!state_.open.empty())
    waiting.push_back(state_.open.pop());
  return count;
}

}  // namespace graze::bvh
#endif
