// The primitives of two leaves, one of each tree, in coordinates as small as they are themselves.
// Included once for each SIMD target.
//
// A primitive is two edges from its first corner on, and a pair of them these four and the way from
// the host's first corner to the guest's, all in the host's frame. A corner of the guest, off by u
// |p| as it is stored, u = 2^-24, is off by 1.74 u g once it is turned, for the guest's reach g; a
// corner of the host by u h. The ways of both first corners from those of their leaves are
// differences of floats, no longer than the leaves' sizes t and s, and the way between these, of
// component o at most, is computed in double and rounded once. With the roundings of the columns,
// of products and of sums the way between two primitives is off by u (1.74 g + h) + 6 u (o + s +
// t), an edge of the guest by u (3.47 g + 5 t), one of the host by u (2 h + s). What doubles round
// is less than a millionth of that. kStoredError is 4 u, kLocalError 8 u.

#if defined(GRAZE_BVH_LOCAL_LEAVES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_LOCAL_LEAVES
#undef GRAZE_BVH_LOCAL_LEAVES
#else
#define GRAZE_BVH_LOCAL_LEAVES
#endif

#include <graze/bvh/wide/front/wide_front.h>
#include <graze/bvh/wide/lanes/pair_lanes-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// How far each component is off: of edges of the host, of the guest, and of the way between first
/// corners, which is off by more than both; infinite where products could overflow.
struct LocalErrors {
  float host;
  float guest;
  float way;
};

/// Two leaves beside each other.
class LocalLeaves {
 public:
  HWY_INLINE LocalLeaves(const WideTree& tree_a, const WideTree& tree_b)
      : trees_{&tree_a, &tree_b} {}

  HWY_INLINE void set(const WideFront::Leaves& leaves, const WideWay& way) {
    const WideTree::Treelet& host = trees_[leaves.host_side]->treelet(leaves.host.treelet);
    const WideTree::Treelet& guest = trees_[1 - leaves.host_side]->treelet(leaves.guest.treelet);
    way_ = &way;
    host_ = rows_of(host, leaves.host.link);
    guest_ = rows_of(guest, leaves.guest.link);
    host_count_ = ChildLink::count(leaves.host.link);
    guest_count_ = ChildLink::count(leaves.guest.link);
    double first[3];
    for (std::uint32_t i = 0; i < 3; ++i) {
      host_first_[i] = host_[i * host_count_];
      guest_first_[i] = guest_[i * guest_count_];
      first[i] = guest.origin[i] + static_cast<double>(guest_first_[i]);
    }
    float largest = 0;
    for (int i = 0; i < 3; ++i) {
      const double turned = way.rotation[i][0] * first[0] + way.rotation[i][1] * first[1] +
                            way.rotation[i][2] * first[2];
      const double place = host.origin[i] + static_cast<double>(host_first_[i]);
      offset_[i] = static_cast<float>((turned * way.scale + way.translation[i]) - place);
      largest = std::max(largest, std::abs(offset_[i]));
    }
    const auto scale = static_cast<float>(way.scale);
    const float size = (leaves.guest.size * scale + leaves.host.size) + largest;
    const float host_error = kStoredError * host.reach;
    const float guest_error = kStoredError * (guest.reach * scale);
    errors_.host = way.slack + (host_error + kLocalError * leaves.host.size);
    errors_.guest = way.slack + (guest_error + kLocalError * (leaves.guest.size * scale));
    errors_.way = size < kLargestPlaneExtent
                      ? way.slack + ((host_error + guest_error) + kLocalError * size)
                      : std::numeric_limits<float>::infinity();
  }

  /// Which pairs they have.
  HWY_INLINE std::uint32_t pairs() const { return pairs_of(host_count_, guest_count_); }

  HWY_INLINE const LocalErrors& errors() const { return errors_; }

  /// Coordinate i of corner c of the first primitive.
  HWY_INLINE const float* host_row(std::uint32_t c, std::uint32_t i) const {
    return host_ + (3 * c + i) * host_count_;
  }
  HWY_INLINE const float* guest_row(std::uint32_t c, std::uint32_t i) const {
    return guest_ + (3 * c + i) * guest_count_;
  }
  HWY_INLINE float host_first(int i) const { return host_first_[i]; }
  HWY_INLINE float guest_first(int i) const { return guest_first_[i]; }

  /// From the host's first corner to the guest's.
  HWY_INLINE float offset(int i) const { return offset_[i]; }

  HWY_INLINE const WideWay& way() const { return *way_; }

 private:
  const WideTree* trees_[2];
  const WideWay* way_ = nullptr;
  const float* host_ = nullptr;
  const float* guest_ = nullptr;
  std::uint32_t host_count_ = 0;
  std::uint32_t guest_count_ = 0;
  float host_first_[3];
  float guest_first_[3];
  float offset_[3];
  LocalErrors errors_;
};

/// Some pairs of the primitives of two leaves, one in each lane.
template <typename AnyTag>
struct LocalPairs {
  using Values = hn::Vec<AnyTag>;

  Values host[2][3];  // edges from the first corner to the others
  Values guest[2][3];
  Values way[3];  // from the host's first corner to the guest's

  /// From pair `first` on.
  HWY_INLINE LocalPairs(const LocalLeaves& leaves, std::size_t first) {
    const AnyTag tag;
    const PairLanes<AnyTag> lanes(first);
    Values turned[3][3];  // what is to be turned, coordinate by coordinate
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto p = lanes.host(leaves.host_row(0, i));
      const auto q = lanes.guest(leaves.guest_row(0, i));
      for (std::uint32_t c = 1; c < 3; ++c) {
        host[c - 1][i] = hn::Sub(lanes.host(leaves.host_row(c, i)), p);
        turned[c][i] = hn::Sub(lanes.guest(leaves.guest_row(c, i)), q);
      }
      turned[0][i] = hn::Sub(q, hn::Set(tag, leaves.guest_first(i)));
      way[i] =
          hn::Sub(hn::Set(tag, leaves.offset(i)), hn::Sub(p, hn::Set(tag, leaves.host_first(i))));
    }
    const WideWay& frame = leaves.way();
    for (int i = 0; i < 3; ++i) {
      const auto x = hn::Set(tag, frame.scaled[0][i]);
      const auto y = hn::Set(tag, frame.scaled[1][i]);
      const auto z = hn::Set(tag, frame.scaled[2][i]);
      way[i] = hn::MulAdd(turned[0][2], z, way[i]);
      way[i] = hn::MulAdd(turned[0][1], y, way[i]);
      way[i] = hn::MulAdd(turned[0][0], x, way[i]);
      for (int c = 1; c < 3; ++c) {
        const auto& edge = turned[c];
        guest[c - 1][i] = hn::MulAdd(edge[0], x, hn::MulAdd(edge[1], y, hn::Mul(edge[2], z)));
      }
    }
  }
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
