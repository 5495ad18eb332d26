#include <graze/engine/work.h>

namespace graze {

Work& Work::operator+=(const Work& other) {
  volume_tests += other.volume_tests;
  volume_rejections += other.volume_rejections;
  filter_tests += other.filter_tests;
  triangle_tests += other.triangle_tests;
  exact_tests += other.exact_tests;
  points_tested += other.points_tested;
  skipped_by_memory += other.skipped_by_memory;
  trees_built += other.trees_built;
  treelets_built += other.treelets_built;
  trees_refitted += other.trees_refitted;
  treelets_refitted += other.treelets_refitted;
  triangles_rebuilt += other.triangles_rebuilt;
  skins_built += other.skins_built;
  convex_tests += other.convex_tests;
  convex_failures += other.convex_failures;
  penetration_tests += other.penetration_tests;
  penetration_failures += other.penetration_failures;
  return *this;
}

}  // namespace graze
