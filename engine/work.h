#pragma once

#include <cstdint>

namespace graze {

/// Counts what queries did and skipped. A query adds to the counters that it is given, so that one
/// Work can sum over many queries. It is exempt from law 8: counts may differ between versions and
/// settings.
struct Work {
  std::uint64_t volume_tests = 0;       ///< pairs of bounding volumes tested
  std::uint64_t volume_rejections = 0;  ///< those of these that were apart: what lies below was
                                        ///< skipped
  std::uint64_t filter_tests = 0;       ///< triangle pairs tested by float before any placing
  std::uint64_t triangle_tests = 0;  ///< triangle/triangle or triangle/box pairs placed and tested
  std::uint64_t exact_tests = 0;     ///< those of these that the rounded stage left unsure
  std::uint64_t points_tested = 0;   ///< points asked whether a closed mesh encloses them
  /// Pairs of boxes of an earlier walk that were not tested again, because what a PairMemory holds
  /// proves them apart; one for a query that it answered without any walk.
  std::uint64_t skipped_by_memory = 0;
  std::uint64_t trees_built = 0;        ///< trees built because this query was the first to walk
                                        ///< them
  std::uint64_t treelets_built = 0;     ///< parts of wide trees, built likewise
  std::uint64_t trees_refitted = 0;     ///< trees of deformed meshes, fitted from those before, not
                                        ///< built
  std::uint64_t treelets_refitted = 0;  ///< parts of wide trees, fitted likewise
  std::uint64_t triangles_rebuilt = 0;  ///< triangles below refitted parts whose SAH cost had
                                        ///< degraded
  std::uint64_t skins_built = 0;        ///< volumes other than boxes, fitted to a tree likewise
  std::uint64_t convex_tests = 0;       ///< distances of two convex cores that were searched for
  std::uint64_t convex_failures = 0;    ///< those of these that proved neither answer: hits
  std::uint64_t penetration_tests = 0;  ///< depths searched for by a polytope
  std::uint64_t penetration_failures = 0;  ///< those of these not proved the least, even with
                                           ///< libccd

  /// Adds each counter of the other to this one's.
  Work& operator+=(const Work& other);

  bool operator==(const Work&) const = default;
};

}  // namespace graze
