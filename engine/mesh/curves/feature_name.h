#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <limits>

namespace graze::contacts {

/// A vertex, an edge or a face of a placed mesh by the numbers of its corners, which ascend.
/// Triangles that share it give it the same name.
struct FeatureName {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::array<std::uint32_t, 3> corner{kNone, kNone, kNone};

  int count() const { return corner[1] == kNone ? 1 : corner[2] == kNone ? 2 : 3; }
  bool is_vertex() const { return count() == 1; }
  bool is_edge() const { return count() == 2; }
  bool is_face() const { return count() == 3; }

  auto operator<=>(const FeatureName&) const = default;
};

/// A point of an intersection: the smallest feature of either mesh in which it lies. Features that
/// are not parallel have one point in common at most, and the corners of the intersection of two
/// triangles are such points: equal names are equal points, exactly.
struct NodeName {
  FeatureName a;
  FeatureName b;

  auto operator<=>(const NodeName&) const = default;
};

}  // namespace graze::contacts
