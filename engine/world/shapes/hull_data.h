#pragma once

#include <graze/engine/world/convex_hull.h>
#include <graze/narrowphase/convex/core/hull.h>

namespace graze {

struct ConvexHullAccess {
  static const narrowphase::Hull& data(const ConvexHull& hull) { return *hull.hull_; }
};

/// Returns the data of a hull that the narrow phase reads.
inline const narrowphase::Hull& data_of(const ConvexHull& hull) {
  return ConvexHullAccess::data(hull);
}

}  // namespace graze
