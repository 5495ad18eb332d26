#pragma once

#include <graze/engine/world/shape.h>

#include <algorithm>
#include <array>

namespace graze::tests {

/// Kinds of shapes that are answered in a way of their own: all but height fields, which say what
/// their meshes say, as tests/engine/height_fields holds them to, and planes, which say what one of
/// their half-spaces does: tests/engine/planes.
inline constexpr auto kOwnKinds = [] {
  std::array<ShapeKind, kShapeKinds.size() - 2> kinds{};
  std::copy_n(kShapeKinds.begin(), kinds.size(), kinds.begin());
  static_assert(kShapeKinds[kinds.size()] == ShapeKind::HeightField);
  static_assert(kShapeKinds.back() == ShapeKind::Plane);
  return kinds;
}();

}  // namespace graze::tests
