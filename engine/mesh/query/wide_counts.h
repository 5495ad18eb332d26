#pragma once

// Private to engine/mesh.

#include <graze/bvh/wide/walk/wide_pair_walk.h>
#include <graze/engine/work.h>

namespace graze {

inline void add_counts(const bvh::TreeletCounts& counts, Work& work) {
  work.treelets_built += counts.built;
  work.treelets_refitted += counts.refitted;
}

inline void add_counts(const bvh::WideWalkCounts& counts, Work& work) {
  work.volume_tests += counts.box_tests;
  work.volume_rejections += counts.box_rejections;
  add_counts(counts.treelets, work);
  work.filter_tests += counts.primitive_tests;
}

}  // namespace graze
