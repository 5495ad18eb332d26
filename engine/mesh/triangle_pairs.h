#pragma once

// The results of queries on meshes: pairs of triangles, triangles, and whether that is all there
// is.

#include <graze/bvh/hash.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace graze {

/// A pair of triangles: `a` of the first mesh and `b` of the second.
struct TrianglePair {
  std::uint32_t a;  ///< index into the triangles of the first mesh
  std::uint32_t b;  ///< index into the triangles of the second mesh
  auto operator<=>(const TrianglePair&) const = default;
};

/// Says whether a list holds all there is.
enum class Completeness { Complete, LimitReached };

/// Pairs in ascending order, without duplicates.
struct TrianglePairs {
  std::vector<TrianglePair> pairs;                     ///< ascending
  Completeness completeness = Completeness::Complete;  ///< LimitReached if there are more

  std::size_t size() const { return pairs.size(); }
  bool empty() const { return pairs.empty(); }
  auto begin() const { return pairs.begin(); }
  auto end() const { return pairs.end(); }
  const TrianglePair& operator[](std::size_t index) const { return pairs[index]; }

  bool operator==(const TrianglePairs&) const = default;
};

/// Indices of triangles in ascending order.
struct TriangleList {
  std::vector<std::uint32_t> triangles;                ///< ascending
  Completeness completeness = Completeness::Complete;  ///< LimitReached if there are more

  std::size_t size() const { return triangles.size(); }
  bool empty() const { return triangles.empty(); }
  auto begin() const { return triangles.begin(); }
  auto end() const { return triangles.end(); }

  bool operator==(const TriangleList&) const = default;
};

}  // namespace graze

template <>
struct std::hash<graze::TrianglePair> {
  std::size_t operator()(const graze::TrianglePair& pair) const noexcept {
    return graze::hash_of({pair.a, pair.b});
  }
};
