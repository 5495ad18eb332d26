#include <graze/bvh/build/sort_split.h>

#include <algorithm>

namespace graze::bvh {

// The rank of a centroid is the number of smaller ones; of equals, those in front are smaller.
SortSplit find_sort_split(std::span<const Reference> references, const SweepCosts& costs) {
  const int count = static_cast<int>(references.size());
  Lanes centroid[kMostSorted];
  IntLanes rank[kMostSorted];
  for (int i = 0; i < count; ++i) {
    centroid[i] = centroid_of(references[i].box);
    rank[i] = IntLanes{i, i, i, i};
    for (int j = 0; j < i; ++j) {
      const IntLanes is_smaller = centroid[i] < centroid[j];
      rank[i] += is_smaller;
      rank[j] -= is_smaller;
    }
  }
  SortSplit split;
  SweepRow rows[kMostSorted];
  for (int i = 0; i < count; ++i) {
    rows[i].count = IntLanes{1, 1, 1, 0};
    for (int k = 0; k < 3; ++k) {
      split.order[rank[i][k]][k] = static_cast<std::uint8_t>(i);
      rows[rank[i][k]].box[k] = references[i].box;
    }
  }
  split.cut = cheapest_cut(rows, count, costs);
  return split;
}

void partition(std::span<Reference> references, const Part& part, const SortSplit& split,
               Part (&sides)[2]) {
  const std::span<Reference> range = references.subspan(part.begin, part.size());
  const std::size_t middle = part.begin + static_cast<std::size_t>(split.cut.row);
  Reference before[kMostSorted];
  std::copy(range.begin(), range.end(), before);
  sides[0] = {part.begin, middle, part.depth + 1};
  sides[1] = {middle, part.end, part.depth + 1};
  for (std::size_t i = 0; i < range.size(); ++i) {
    range[i] = before[split.order[i][split.cut.axis]];
    Part& side = sides[i < static_cast<std::size_t>(split.cut.row) ? 0 : 1];
    side.box = merged(side.box, range[i].box);
  }
}

}  // namespace graze::bvh
