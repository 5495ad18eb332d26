#pragma once

#include <graze/narrowphase/derived/simplex.h>
#include <graze/narrowphase/triangle_distance.h>
#include <optional>

namespace graze::narrowphase {

/// Names features of two triangles that hold their nearest points: vertices and edges by number,
/// edges as in simplex.h. A face goes with a vertex.
struct FeaturePair {
  Feature kind_a;
  int index_a;
  Feature kind_b;
  int index_b;
};

/// Returns the features that look nearest to rounded arithmetic: any answer is possible, most are
/// right.
FeaturePair guess_nearest(const OrderedTriangles& triangles);

/// Returns features that rounded arithmetic with bounds proves to hold the only pair of nearest
/// points, and nothing when that is not sure, as when the triangles meet.
std::optional<FeaturePair> find_surely_nearest(const OrderedTriangles& triangles);

/// Returns features that hold a pair of nearest points, exactly. The triangles must not meet.
FeaturePair find_nearest_exactly(const OrderedTriangles& triangles);

}  // namespace graze::narrowphase
