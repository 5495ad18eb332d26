#pragma once

// Holds the stages of the distance of two triangles: what the whole answers, and how points are
// rounded once the nearest features are known.

#include <graze/narrowphase/derived/nearest_features.h>
#include <graze/narrowphase/predicates/verdict.h>
#include <graze/narrowphase/triangle_distance.h>
#include <array>
#include <optional>

namespace graze::narrowphase {

/// Holds what distance() answers, and which stage found the features and the numbers: Triage only
/// if no exact stage was asked for either.
struct StagedDistance {
  TriangleDistance result;
  Stage stage;
};

StagedDistance decide_distance(const Triangle& triangle_a, const Triangle& triangle_b);

/// Returns what distance() answers, by the exact stages alone.
TriangleDistance distance_exactly(const Triangle& triangle_a, const Triangle& triangle_b);

/// Holds the nearest points and their distance, rounded.
struct Witness {
  double distance;
  std::array<double, 3> point_a;
  std::array<double, 3> point_b;
};

/// Returns the nearest points of triangles that do not meet, from features that hold them, computed
/// in twice the precision of double, or nothing where that could miss the bounds of law 7.
std::optional<Witness> rounded_witness(const OrderedTriangles& triangles, const FeaturePair& pair);

/// Returns the same from integers, with one rounding for each number. The distance is not 0.
Witness exact_witness(const OrderedTriangles& triangles, const FeaturePair& pair);

}  // namespace graze::narrowphase
