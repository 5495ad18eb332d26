#pragma once

#include <array>

#include <graze/narrowphase/derived/nearest_features.h>
#include <optional>

namespace graze::narrowphase {

/// The nearest points and their distance, rounded.
struct Witness {
  double distance;
  std::array<double, 3> point_a;
  std::array<double, 3> point_b;
};

/// Of features that hold nearest points of triangles that do not meet. From twice the precision of
/// double; empty where that could miss the bounds of law 7.
std::optional<Witness> rounded_witness(const OrderedTriangles& triangles, const FeaturePair& pair);

/// From integers, with one rounding each. The distance is not 0.
Witness exact_witness(const OrderedTriangles& triangles, const FeaturePair& pair);

}  // namespace graze::narrowphase
