// This puts the primitives of two leaves, one of each tree, into coordinates as small as they are
// themselves. It is included once for each SIMD target.
//
// A primitive is stored as two edges from its first corner, and a pair of primitives as these four
// and the offset from the tested primitive's first corner to the other's, all in the tested node's
// frame. How far they are off is derived beside kStoredError (wide_bounds.h).

#if defined(GRAZE_BVH_LOCAL_LEAVES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_LOCAL_LEAVES
#undef GRAZE_BVH_LOCAL_LEAVES
#else
#define GRAZE_BVH_LOCAL_LEAVES
#endif

#include <graze/bvh/wide/front/wide_front.h>
#include <graze/bvh/wide/lanes/leaf_crossings-inl.h>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Says how far each component is off: of edges of the tested node, of the query box, and of the
/// offset between first corners, which is off by no less than both. The errors are infinite where
/// products could overflow.
struct LocalErrors {
  float tested;
  float query;
  float offset;

  /// Returns the same errors for all pairs of two leaves.
  template <typename AnyTag>
  HWY_INLINE PairErrors<AnyTag> of_pairs(AnyTag tag) const {
    return {hn::Set(tag, tested), hn::Set(tag, query), hn::Set(tag, offset)};
  }
};

/// Two leaves beside each other, in local coordinates.
class LocalLeaves {
 public:
  HWY_INLINE LocalLeaves(const WideTree& tree_a, const WideTree& tree_b)
      : trees_{&tree_a, &tree_b} {}

  HWY_INLINE void set(const WideFront::Leaves& leaves, const TreeTransform& transform) {
    const WideTree::Treelet& tested = trees_[leaves.tested_side]->treelet(leaves.tested.treelet);
    const WideTree::Treelet& query = trees_[1 - leaves.tested_side]->treelet(leaves.query.treelet);
    transform_ = &transform;
    tested_ = rows_of(tested, leaves.tested.link);
    query_ = rows_of(query, leaves.query.link);
    tested_count_ = ChildLink::count(leaves.tested.link);
    query_count_ = ChildLink::count(leaves.query.link);
    double first[3];
    for (std::uint32_t i = 0; i < 3; ++i) {
      tested_first_[i] = tested_[i * tested_count_];
      query_first_[i] = query_[i * query_count_];
      first[i] = query.origin[i] + static_cast<double>(query_first_[i]);
    }
    float largest = 0;
    for (int i = 0; i < 3; ++i) {
      const double turned = transform.rotation[i][0] * first[0] +
                            transform.rotation[i][1] * first[1] +
                            transform.rotation[i][2] * first[2];
      const double place = tested.origin[i] + static_cast<double>(tested_first_[i]);
      offset_[i] =
          static_cast<float>((turned * transform.scale + transform.translation[i]) - place);
      largest = std::max(largest, std::abs(offset_[i]));
    }
    const auto scale = static_cast<float>(transform.scale);
    const float size = (leaves.query.size * scale + leaves.tested.size) + largest;
    const float tested_error = kStoredError * tested.largest_coordinate;
    const float query_error = kStoredError * (query.largest_coordinate * scale);
    errors_.tested = transform.slack + (tested_error + kLocalError * leaves.tested.size);
    errors_.query = transform.slack + (query_error + kLocalError * (leaves.query.size * scale));
    errors_.offset = size < kLargestPlaneExtent
                         ? transform.slack + ((tested_error + query_error) + kLocalError * size)
                         : std::numeric_limits<float>::infinity();
  }

  /// Returns the bits of the pairs that they have.
  HWY_INLINE std::uint32_t pairs() const { return pairs_of(tested_count_, query_count_); }

  HWY_INLINE const LocalErrors& errors() const { return errors_; }

  /// Return coordinate i of corner c of the first primitive.
  HWY_INLINE const float* tested_row(std::uint32_t c, std::uint32_t i) const {
    return tested_ + (3 * c + i) * tested_count_;
  }
  HWY_INLINE const float* query_row(std::uint32_t c, std::uint32_t i) const {
    return query_ + (3 * c + i) * query_count_;
  }
  HWY_INLINE float tested_first(int i) const { return tested_first_[i]; }
  HWY_INLINE float query_first(int i) const { return query_first_[i]; }

  /// Returns coordinate i of the offset from the tested node's first corner to the query box's.
  HWY_INLINE float offset(int i) const { return offset_[i]; }

  HWY_INLINE const TreeTransform& transform() const { return *transform_; }

 private:
  const WideTree* trees_[2];
  const TreeTransform* transform_ = nullptr;
  const float* tested_ = nullptr;
  const float* query_ = nullptr;
  std::uint32_t tested_count_ = 0;
  std::uint32_t query_count_ = 0;
  float tested_first_[3];
  float query_first_[3];
  float offset_[3];
  LocalErrors errors_;
};

/// Some pairs of the primitives of two leaves, one in each lane.
template <typename AnyTag>
struct LocalPairs : PairEdges<AnyTag> {
  using Values = hn::Vec<AnyTag>;
  using PairEdges<AnyTag>::offset;
  using PairEdges<AnyTag>::query;
  using PairEdges<AnyTag>::tested;

  /// Reads the pairs from pair `first` on.
  HWY_INLINE LocalPairs(const LocalLeaves& leaves, std::size_t first) {
    const AnyTag tag;
    const PairLanes<AnyTag> lanes(first);
    Values turned[3][3];  // the corners that are to be turned, coordinate by coordinate
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto p = lanes.tested(leaves.tested_row(0, i));
      const auto q = lanes.query(leaves.query_row(0, i));
      for (std::uint32_t c = 1; c < 3; ++c) {
        tested[c - 1][i] = hn::Sub(lanes.tested(leaves.tested_row(c, i)), p);
        turned[c][i] = hn::Sub(lanes.query(leaves.query_row(c, i)), q);
      }
      turned[0][i] = hn::Sub(q, hn::Set(tag, leaves.query_first(i)));
      offset[i] =
          hn::Sub(hn::Set(tag, leaves.offset(i)), hn::Sub(p, hn::Set(tag, leaves.tested_first(i))));
    }
    const TreeTransform& transform = leaves.transform();
    for (int i = 0; i < 3; ++i) {
      const auto x = hn::Set(tag, transform.scaled[0][i]);
      const auto y = hn::Set(tag, transform.scaled[1][i]);
      const auto z = hn::Set(tag, transform.scaled[2][i]);
      offset[i] = hn::MulAdd(turned[0][2], z, offset[i]);
      offset[i] = hn::MulAdd(turned[0][1], y, offset[i]);
      offset[i] = hn::MulAdd(turned[0][0], x, offset[i]);
      for (int c = 1; c < 3; ++c) {
        const auto& edge = turned[c];
        query[c - 1][i] = hn::MulAdd(edge[0], x, hn::MulAdd(edge[1], y, hn::Mul(edge[2], z)));
      }
    }
  }
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
