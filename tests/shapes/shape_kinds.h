#pragma once

#include <graze/engine/world/shape.h>

#include <algorithm>
#include <array>

namespace graze::tests {

/// Kinds of shapes that are answered in a way of their own: all but height fields, which say what
/// their meshes say, as tests/engine/height_fields holds them to.
inline constexpr auto kOwnKinds = [] {
  std::array<ShapeKind, kShapeKinds.size() - 1> kinds{};
  std::copy_n(kShapeKinds.begin(), kinds.size(), kinds.begin());
  static_assert(kShapeKinds.back() == ShapeKind::HeightField);
  return kinds;
}();

}  // namespace graze::tests
