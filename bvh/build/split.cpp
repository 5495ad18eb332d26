#include <graze/bvh/build/bin_split.h>
#include <graze/bvh/build/sort_split.h>
#include <graze/bvh/build/split.h>

#include <algorithm>

namespace graze::bvh {
namespace {

/// From this depth on ranges are halved by count, whatever the heuristic says.
constexpr int kMaxHeuristicDepth = 64;

/// True if a cut promises less than a leaf. Nothing is divided by the measure of the part, which
/// may be zero.
bool is_cheaper_than_leaf(const Cut& cut, const Part& part, const SweepCosts& costs,
                          float primitive_cost) {
  const float of_part = measured(part.box, costs.measure);
  const float weight = weight_of(all_lanes(static_cast<float>(part.size())), costs)[0];
  return cut.axis >= 0 && of_part + primitive_cost * cut.cost < primitive_cost * weight * of_part;
}

int widest_axis(const CentroidBounds& centroids) {
  const Lanes width = centroids.high + centroids.minus_low;
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (width[k] > width[axis]) axis = k;
  }
  return axis;
}

/// Splits a part into two halves of equal count along the axis on which the centroids spread
/// widest.
void halve(std::span<Reference> references, const Part& part, Part (&sides)[2]) {
  const std::span<Reference> range = references.subspan(part.begin, part.size());
  const int axis = widest_axis(part_of(references, part.begin, part.end, 0).centroids);
  // The references are sorted, because the order that nth_element leaves is for the library to
  // choose.
  std::sort(range.begin(), range.end(), [axis](const Reference& a, const Reference& b) {
    const float of_a = centroid_of(a.box)[axis];
    const float of_b = centroid_of(b.box)[axis];
    return of_a != of_b ? of_a < of_b : a.index() < b.index();
  });
  const std::size_t middle = part.begin + range.size() / 2;
  sides[0] = part_of(references, part.begin, middle, part.depth + 1);
  sides[1] = part_of(references, middle, part.end, part.depth + 1);
}

}  // namespace

SplitResult split(std::span<Reference> references, const Part& part, const BuildSettings& settings,
                  Part (&sides)[2]) {
  const bool is_leaf_allowed = part.size() <= settings.max_leaf_size;
  const SweepCosts costs{.measure = measure_for(part.box),
                         .leaf_size = static_cast<float>(std::max(settings.max_leaf_size, 1u)),
                         .empty_place = settings.empty_place_cost};
  const auto is_leaf = [&](const Cut& cut) {
    return is_leaf_allowed && !is_cheaper_than_leaf(cut, part, costs, settings.primitive_cost);
  };
  if (part.depth >= kMaxHeuristicDepth) {
    if (is_leaf_allowed) return SplitResult::Leaf;
    halve(references, part, sides);
  } else if (part.size() <= kMostSorted) {
    const SortSplit sorted = find_sort_split(references.subspan(part.begin, part.size()), costs);
    if (is_leaf(sorted.cut)) return SplitResult::Leaf;
    partition(references, part, sorted, sides);
  } else {
    const BinSplit binned = find_bin_split(references, part, costs);
    if (is_leaf(binned.cut)) return SplitResult::Leaf;
    if (binned.cut.axis < 0) {
      halve(references, part, sides);
    } else {
      partition(references, part, binned, sides);
    }
  }
  return SplitResult::Inner;
}

}  // namespace graze::bvh
