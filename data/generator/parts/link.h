#pragma once

#include "data/generator/surface.h"

namespace graze::generator {

/// A link of round steel chain: a wire bent around two half circles that straight legs join.
/// Millimetres.
struct ChainLink {
  double wire;   ///< diameter
  double pitch;  ///< length of the opening
  double width;  ///< over all, across the legs

  /// Radius of the half circles that the wire's middle line follows.
  double bend_radius() const { return (width - wire) / 2; }

  /// Half the length of a leg: how far the half circles' centres are from the middle.
  double half_leg() const { return (pitch + wire) / 2 - bend_radius(); }
};

inline constexpr ChainLink kLink{6, 18.5, 20.4};

/// The link in the plane z = 0, its length along x, its middle in the origin. Millimetres.
Surface make_link(const ChainLink& link);

}  // namespace graze::generator
