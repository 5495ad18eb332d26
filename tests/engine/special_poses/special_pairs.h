#pragma once

// Pairs of shapes in special position: along the same axes or at right angles, concentric,
// coaxial, just touching, equal, and all of these by a little not.

#include <cstddef>
#include <cstdint>

#include "tests/engine/special_poses/least_width.h"
#include "tests/shapes/random_source.h"
#include "tests/shapes/shape_kinds.h"

namespace graze::tests {

/// How many of kOwnKinds, the first, are convex and bounded.
inline constexpr std::size_t kConvexKinds = 7;

/// The rotations that map the axes of a frame to its axes.
inline constexpr std::size_t kRightTurns = 24;
Eigen::Matrix3d right_turn(std::size_t index);

/// Shapes of a kind whose lengths are powers of two or nearly so; `index` counts without end.
Shape plain_shape(ShapeKind kind, std::size_t index);

enum class SpecialPlace {
  Concentric,  ///< middle upon middle
  Offset,      ///< moved along an axis, by a share of the sizes
  Touching,    ///< moved along an axis until the widths along it are 0, but for rounding
};

/// A pair of plain shapes, B turned by right_turn(turn).
PlacedPair special_pair(ShapeKind kind_a, ShapeKind kind_b, std::size_t turn, SpecialPlace place,
                        std::size_t index);

/// A special pair drawn at random, of which every other is changed: turned as one, moved or turned
/// by between 1e-16 and 1e-3, scaled, or given the sizes of any shape.
/// Of the first so many of kOwnKinds, but never two half-spaces.
PlacedPair drawn_pair(RandomSource& source, std::size_t kinds = kConvexKinds);

/// The same pair, all lengths times a factor.
PlacedPair scaled(const PlacedPair& pair, double factor);

}  // namespace graze::tests
