#include <graze/bvh/build/bin_split.h>

#include <algorithm>

namespace graze::bvh {
namespace {

/// Returns the number of bins. Few references need few bins: most nodes are near the leaves, where
/// sweeping costs the most.
int bin_count(std::size_t references) {
  return references <= 32 ? 8 : kMostRows;
}

/// Returns how many references there are for each that is put into a bin: a few thousand tell where
/// to cut as well as all do, and boxes are cheaper to find along the way to the sides than in three
/// bins each.
std::size_t stride_of(std::size_t references) {
  return references < 8192 ? 1 : references / 2048;
}

/// Centroids closer together than this, in local units, are one: dividing by less could overflow.
constexpr float kSmallestExtent = 1e-30f;

void fill(SweepRow* bins, std::span<const Reference> references, std::size_t stride,
          const BinSplit& split, int count) {
  std::fill_n(bins, count, empty_row());
  const Lanes low = split.low;
  const Lanes bins_per_unit = split.bins_per_unit;
  const Lanes last = all_lanes(static_cast<float>(count - 1));
  for (std::size_t i = 0; i < references.size(); i += stride) {
    const Bounds box = references[i].box;
    const Lanes place = smaller((centroid_of(box) - low) * bins_per_unit, last);
    const IntLanes bin = __builtin_convertvector(place, IntLanes);
    for (int k = 0; k < 3; ++k) {
      SweepRow& row = bins[static_cast<std::uint32_t>(bin[k])];
      row.box[k] = merged(box, row.box[k]);
      ++row.count[k];
    }
  }
}

/// Adds a box where a mask is not set; NaN adds nothing.
void extend(Bounds& bounds, const Bounds& box, IntLanes mask) {
  bounds.minus_min =
      larger(std::bit_cast<Lanes>(std::bit_cast<IntLanes>(box.minus_min) | mask), bounds.minus_min);
  bounds.max = larger(std::bit_cast<Lanes>(std::bit_cast<IntLanes>(box.max) | mask), bounds.max);
}

/// Moves the references in front of the cut to the front. Each reference changes places with the
/// first of those behind, which then is one further on if it belongs in front: a branch would be
/// mispredicted every other time. In a mask all bits set are NaN, which adds nothing.
template <int kAxis, bool kWithBoxes>
std::size_t partition_along(std::span<Reference> range, const BinSplit& split,
                            CentroidBounds (&centroids)[2], Bounds (&boxes)[2]) {
  const Lanes low = all_lanes(split.low[kAxis]);
  const Lanes bins_per_unit = all_lanes(split.bins_per_unit[kAxis]);
  const Lanes row = all_lanes(static_cast<float>(split.cut.row));
  Reference* behind = range.data();
  CentroidBounds of_front = empty_centroid_bounds();
  CentroidBounds of_behind = empty_centroid_bounds();
  for (Reference& place : range) {
    const Reference reference = place;
    const Lanes centroid = centroid_of(reference.box);
    const Lanes along = __builtin_shufflevector(centroid, centroid, kAxis, kAxis, kAxis, kAxis);
    // This is the sign of a difference, which is zero for equals only. A comparison would do, but
    // g++ 12 makes more of what follows it.
    const IntLanes is_front = std::bit_cast<IntLanes>((along - low) * bins_per_unit - row) >> 31;
    const IntLanes is_behind = ~is_front;
    const IntLanes of_centroid = std::bit_cast<IntLanes>(centroid);
    extend(of_front, std::bit_cast<Lanes>(of_centroid | is_behind));
    extend(of_behind, std::bit_cast<Lanes>(of_centroid | is_front));
    if constexpr (kWithBoxes) {
      extend(boxes[0], reference.box, is_behind);
      extend(boxes[1], reference.box, is_front);
    }
    place = *behind;
    *behind = reference;
    behind -= is_front[0];
  }
  centroids[0] = of_front;
  centroids[1] = of_behind;
  return static_cast<std::size_t>(behind - range.data());
}

template <bool kWithBoxes>
std::size_t partition(std::span<Reference> range, const BinSplit& split,
                      CentroidBounds (&centroids)[2], Bounds (&boxes)[2]) {
  switch (split.cut.axis) {
    case 0:
      return partition_along<0, kWithBoxes>(range, split, centroids, boxes);
    case 1:
      return partition_along<1, kWithBoxes>(range, split, centroids, boxes);
    default:
      return partition_along<2, kWithBoxes>(range, split, centroids, boxes);
  }
}

}  // namespace

BinSplit find_bin_split(std::span<const Reference> references, const Part& part,
                        const SweepCosts& costs) {
  const std::span<const Reference> range = references.subspan(part.begin, part.size());
  const int count = bin_count(range.size());
  const Lanes width = part.centroids.high + part.centroids.minus_low;
  const IntLanes is_wide = (width > all_lanes(kSmallestExtent)) & IntLanes{-1, -1, -1, 0};
  const Lanes per_unit =
      all_lanes(static_cast<float>(count)) / chosen(is_wide, width, all_lanes(1));
  BinSplit split;
  split.low = -part.centroids.minus_low;
  split.bins_per_unit = chosen(is_wide, per_unit, all_lanes(0));
  SweepRow bins[kMostRows];
  const std::size_t stride = stride_of(range.size());
  fill(bins, range, stride, split, count);
  split.is_sampled = stride > 1;
  split.cut = cheapest_cut(bins, count, costs);
  split.boxes[0] = split.boxes[1] = empty_bounds();
  if (split.cut.axis < 0 || split.is_sampled) return split;
  for (int i = 0; i < count; ++i) {
    Bounds& side = split.boxes[i < split.cut.row ? 0 : 1];
    side = merged(side, bins[i].box[split.cut.axis]);
  }
  return split;
}

// A centroid falls in front of a bin if and only if its place, before it is rounded down to a whole
// bin, is below that bin's number.
void partition(std::span<Reference> references, const Part& part, const BinSplit& split,
               Part (&sides)[2]) {
  const std::span<Reference> range = references.subspan(part.begin, part.size());
  CentroidBounds centroids[2];
  Bounds boxes[2] = {split.boxes[0], split.boxes[1]};
  const std::size_t in_front = split.is_sampled ? partition<true>(range, split, centroids, boxes)
                                                : partition<false>(range, split, centroids, boxes);
  const std::size_t middle = part.begin + in_front;
  sides[0] = {part.begin, middle, part.depth + 1, boxes[0], centroids[0]};
  sides[1] = {middle, part.end, part.depth + 1, boxes[1], centroids[1]};
}

}  // namespace graze::bvh
