// Pairs of primitives from different leaves, a lane each, until there are enough to decide at once
// which of them cross. Included once for each SIMD target.

#if defined(GRAZE_BVH_PAIR_BATCH) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_PAIR_BATCH
#undef GRAZE_BVH_PAIR_BATCH
#else
#define GRAZE_BVH_PAIR_BATCH
#endif

#include <graze/bvh/wide/lanes/leaf_crossings-inl.h>
#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <graze/bvh/wide/walk/wide_pair_walk.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// The edges of a query box's leaf along the axes of the tested node's tree, from first corners to
/// the others: turned before they are moved, so that they are as exact as they are small.
struct QueryEdges {
  alignas(16) float edge[2][3][4];
  float error;  ///< of each component
};

HWY_INLINE void set_query_edges(QueryEdges& edges, const WideTree::Treelet& query,
                                const WideChildRef& leaf, const TreeTransform& transform) {
  const FourTag tag;
  const std::uint32_t link = leaf.node->child[leaf.lane];
  const std::uint32_t count = ChildLink::count(link);
  const float* rows = rows_of(query, link);
  const auto scale = static_cast<float>(transform.scale);
  edges.error = transform.slack + (kStoredError * (query.largest_coordinate * scale) +
                                   kLocalError * (2 * size_of(leaf) * scale));
  for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
    const auto row = [&](std::uint32_t corner, std::uint32_t i) HWY_ATTR {
      return hn::LoadU(tag, rows + (3 * corner + i) * count + part);
    };
    for (std::uint32_t c = 1; c < 3; ++c) {
      Four edge[3];
      for (std::uint32_t i = 0; i < 3; ++i)
        edge[i] = hn::Sub(row(c, i), row(0, i));
      for (int i = 0; i < 3; ++i) {
        const Four turned =
            hn::MulAdd(edge[0], hn::Set(tag, transform.scaled[0][i]),
                       hn::MulAdd(edge[1], hn::Set(tag, transform.scaled[1][i]),
                                  hn::Mul(edge[2], hn::Set(tag, transform.scaled[2][i]))));
        hn::Store(turned, tag, edges.edge[c - 1][i] + part);
      }
    }
  }
}

/// How far edges of a tested leaf are off, as differences of corners as they are stored.
HWY_INLINE float tested_edge_error(const WideTree::Treelet& tested, const WideChildRef& leaf,
                                   float slack) {
  return slack + (kStoredError * tested.largest_coordinate + kLocalError * (2 * size_of(leaf)));
}

/// Few primitives of two leaves are left when boxes and planes have been asked: each pair is copied
/// to a lane of its own, so that no lane is idle.
class PairBatch {
 public:
  std::size_t size() const { return size_; }
  bool is_full() const { return size_ == hn::Lanes(PairTag()); }

  /// Two leaves beside each other.
  struct Leaves {
    const LeafLanes& tested;
    const QueryLeaf& query;
    const QueryEdges& query_edges;
    float tested_error;  ///< of its edges
  };

  /// Primitive i of the tested leaf and j of the other. It must not be full.
  HWY_INLINE void add(const Leaves& leaves, std::size_t i, std::size_t j, PlacePair places) {
    if (!is_cleared_) clear();
    for (int k = 0; k < 3; ++k) {
      for (int c = 0; c < 3; ++c)
        tested_[c][k][size_] = leaves.tested.corner[c][k][i];
      for (int c = 0; c < 2; ++c)
        query_[c][k][size_] = leaves.query_edges.edge[c][k][j];
      query_first_[k][size_] = leaves.query.corner[0][k][j];
    }
    tested_error_[size_] = leaves.tested_error;
    query_error_[size_] = leaves.query_edges.error;
    error_[size_] = leaves.query.sign_error;
    places_[size_] = places;
    ++size_;
  }

  /// Writes those that are not surely apart to `found`, in the order in which they came, and is
  /// empty. Returns how many it wrote. It must not be empty.
  HWY_NOINLINE std::size_t decide(FoundPair* found) {
    const PairTag tag;
    const auto of_tested = hn::Load(tag, tested_error_);
    const auto of_query = hn::Load(tag, query_error_);
    const auto of_offset = hn::Max(hn::Max(of_tested, of_query), hn::Load(tag, error_));
    const LeafCrossings<PairTag> crossings(edges(), {of_tested, of_query, of_offset});
    const std::uint32_t crossing = bits_of(tag, crossings.do_cross);
    std::uint32_t open = ((1u << size_) - 1) & ~bits_of(tag, crossings.are_apart);
    std::size_t count = 0;
    for (; open != 0; open &= open - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(open));
      found[count++] = {places_[lane], (crossing >> lane & 1) != 0};
    }
    size_ = 0;
    return count;
  }

 private:
  HWY_INLINE PairEdges<PairTag> edges() const {
    const PairTag tag;
    PairEdges<PairTag> edges;
    for (int k = 0; k < 3; ++k) {
      const auto p = hn::Load(tag, tested_[0][k]);
      for (int c = 1; c < 3; ++c) {
        edges.tested[c - 1][k] = hn::Sub(hn::Load(tag, tested_[c][k]), p);
        edges.query[c - 1][k] = hn::Load(tag, query_[c - 1][k]);
      }
      edges.offset[k] = hn::Sub(hn::Load(tag, query_first_[k]), p);
    }
    return edges;
  }

  HWY_NOINLINE void clear() {
    std::fill_n(&tested_[0][0][0], 9 * kLeafPairs, 0.0f);
    std::fill_n(&query_[0][0][0], 6 * kLeafPairs, 0.0f);
    std::fill_n(&query_first_[0][0], 3 * kLeafPairs, 0.0f);
    std::fill_n(tested_error_, kLeafPairs, 0.0f);
    std::fill_n(query_error_, kLeafPairs, 0.0f);
    std::fill_n(error_, kLeafPairs, 0.0f);
    is_cleared_ = true;
  }

  // Cleared by the first add(), because lanes that hold no pair are computed, too; not before,
  // because many walks end without any.
  alignas(64) float tested_[3][3][kLeafPairs];  ///< [corner][component]
  alignas(64) float query_[2][3][kLeafPairs];   ///< edges
  alignas(64) float query_first_[3][kLeafPairs];
  alignas(64) float tested_error_[kLeafPairs];
  alignas(64) float query_error_[kLeafPairs];
  alignas(64) float error_[kLeafPairs];
  PlacePair places_[kLeafPairs];
  std::size_t size_ = 0;
  bool is_cleared_ = false;
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
