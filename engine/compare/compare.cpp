#include <graze/engine/compare/compare.h>
#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <iterator>

namespace graze::compare {
namespace {

bool do_triangles_meet(const TrianglePair& pair, const PlacedMeshView& mesh_a,
                       const PlacedMeshView& mesh_b) {
  return referee_intersects(place(mesh_a.pose, mesh_a.mesh.triangle(pair.a)),
                            place(mesh_b.pose, mesh_b.mesh.triangle(pair.b)));
}

void add(Comparison& comparison, const Difference& difference) {
  comparison.differences.push_back(difference);
  if (difference.graze_says != difference.truth) ++comparison.graze_wrong;
  if (difference.fcl_says != difference.truth) ++comparison.fcl_wrong;
}

}  // namespace

Comparison compare_pairs(std::span<const TrianglePair> graze_pairs,
                         std::span<const TrianglePair> fcl_pairs, const PlacedMeshView& mesh_a,
                         const PlacedMeshView& mesh_b) {
  Comparison comparison;
  comparison.graze_intersects = !graze_pairs.empty();
  comparison.fcl_intersects = !fcl_pairs.empty();
  comparison.graze_pairs = graze_pairs.size();
  comparison.fcl_pairs = fcl_pairs.size();

  std::vector<TrianglePair> disputed;
  std::set_symmetric_difference(graze_pairs.begin(), graze_pairs.end(), fcl_pairs.begin(),
                                fcl_pairs.end(), std::back_inserter(disputed));
  for (const TrianglePair& pair : disputed) {
    const bool graze_says = std::binary_search(graze_pairs.begin(), graze_pairs.end(), pair);
    add(comparison, {pair, graze_says, !graze_says, do_triangles_meet(pair, mesh_a, mesh_b)});
  }
  return comparison;
}

Comparison compare_pairs(const Side& side_a, const Side& side_b) {
  return compare_pairs(
      find_triangle_pairs(side_a.placed, side_b.placed).pairs,
      find_triangle_pairs(side_a.fcl, side_a.placed.pose, side_b.fcl, side_b.placed.pose),
      side_a.placed, side_b.placed);
}

Comparison compare_any(bool graze_intersects, bool fcl_intersects,
                       std::span<const TrianglePair> witnesses, const PlacedMeshView& mesh_a,
                       const PlacedMeshView& mesh_b) {
  Comparison comparison;
  comparison.graze_intersects = graze_intersects;
  comparison.fcl_intersects = fcl_intersects;
  if (graze_intersects == fcl_intersects) return comparison;

  const auto proof = std::find_if(
      witnesses.begin(), witnesses.end(),
      [&](const TrianglePair& pair) { return do_triangles_meet(pair, mesh_a, mesh_b); });
  if (proof != witnesses.end()) {
    add(comparison, {*proof, graze_intersects, fcl_intersects, true});
  } else if (!witnesses.empty()) {
    add(comparison, {witnesses.front(), graze_intersects, fcl_intersects, false});
  } else {  // its own engine cannot show this yes: there is no pair to name
    ++(graze_intersects ? comparison.graze_wrong : comparison.fcl_wrong);
  }
  return comparison;
}

Comparison compare_any(bool graze_intersects, const Side& side_a, const Side& side_b) {
  const bool fcl_intersects =
      intersects(side_a.fcl, side_a.placed.pose, side_b.fcl, side_b.placed.pose);
  std::vector<TrianglePair> witnesses;
  if (graze_intersects && !fcl_intersects) {
    witnesses = find_triangle_pairs(side_a.placed, side_b.placed).pairs;
  } else if (fcl_intersects && !graze_intersects) {
    witnesses = find_triangle_pairs(side_a.fcl, side_a.placed.pose, side_b.fcl, side_b.placed.pose);
  }
  return compare_any(graze_intersects, fcl_intersects, witnesses, side_a.placed, side_b.placed);
}

Comparison compare_any(const Side& side_a, const Side& side_b) {
  return compare_any(intersects(side_a.placed, side_b.placed), side_a, side_b);
}

}  // namespace graze::compare
