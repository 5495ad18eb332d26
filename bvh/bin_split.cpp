#include <graze/bvh/bin_split.h>

#include <algorithm>

namespace graze::bvh {
namespace {

/// Few references need few bins: most nodes are near the leaves, where sweeping costs the most.
int bin_count(std::size_t references) {
  return references <= 16 ? 8 : kMostRows;
}

/// Centroids closer together than this, in local units, are one: dividing by less could overflow.
constexpr float kSmallestSpread = 1e-30f;

struct Bins {
  SweepRow row[kMostRows];
  std::uint32_t count[kMostRows][4];
};

void clear(Bins& bins, int count) {
  for (int i = 0; i < count; ++i) {
    for (Bounds& box : bins.row[i].box)
      box = empty_bounds();
    for (std::uint32_t& number : bins.count[i])
      number = 0;
  }
}

void fill(Bins& bins, std::span<const Reference> references, const BinSplit& split, int count) {
  const Lanes low = split.low;
  const Lanes bins_per_unit = split.bins_per_unit;
  const Lanes last = all_lanes(static_cast<float>(count - 1));
  for (const Reference& reference : references) {
    const Bounds box = reference.box;
    const Lanes place = smaller((centroid_of(box) - low) * bins_per_unit, last);
    const IntLanes bin = __builtin_convertvector(place, IntLanes);
    for (int k = 0; k < 3; ++k) {
      Bounds& sum = bins.row[bin[k]].box[k];
      sum = merged(sum, box);
      ++bins.count[bin[k]][k];
    }
  }
  for (int i = 0; i < count; ++i) {
    const std::uint32_t* number = bins.count[i];
    bins.row[i].count = Lanes{static_cast<float>(number[0]), static_cast<float>(number[1]),
                              static_cast<float>(number[2]), 0};
  }
}

}  // namespace

BinSplit find_bin_split(std::span<const Reference> references, const Part& part, Measure measure) {
  const std::span<const Reference> range = references.subspan(part.begin, part.size());
  const int count = bin_count(range.size());
  const Lanes width = part.spread.high + part.spread.minus_low;
  const IntLanes is_wide = (width > all_lanes(kSmallestSpread)) & IntLanes{-1, -1, -1, 0};
  const Lanes per_unit =
      all_lanes(static_cast<float>(count)) / chosen(is_wide, width, all_lanes(1));
  BinSplit split;
  split.low = -part.spread.minus_low;
  split.bins_per_unit = chosen(is_wide, per_unit, all_lanes(0));
  Bins bins;
  clear(bins, count);
  fill(bins, range, split, count);
  split.cut = cheapest_cut(bins.row, count, measure);
  if (split.cut.axis < 0) return split;
  split.first_size = 0;
  split.boxes[0] = split.boxes[1] = empty_bounds();
  for (int i = 0; i < count; ++i) {
    Bounds& side = split.boxes[i < split.cut.row ? 0 : 1];
    side = merged(side, bins.row[i].box[split.cut.axis]);
    if (i < split.cut.row) split.first_size += bins.count[i][split.cut.axis];
  }
  return split;
}

// A centroid falls in front of a bin if and only if its place, before it is rounded down to a whole
// bin, is below that bin's number. Each reference is written to both sides, and the place on the
// wrong one is written again: a branch would be mispredicted every other time.
void partition(std::span<Reference> references, const Part& part, const BinSplit& split,
               Reference* scratch, Part (&sides)[2]) {
  const int axis = split.cut.axis;
  const float low = split.low[axis];
  const float bins_per_unit = split.bins_per_unit[axis];
  const float row = static_cast<float>(split.cut.row);
  Reference* const begin = references.data() + part.begin;
  Reference* const end = references.data() + part.end;
  Reference* front = begin;
  Reference* behind = scratch;
  Spread spreads[2] = {empty_spread(), empty_spread()};
  for (const Reference* from = begin; from < end; ++from) {
    const Reference reference = *from;
    const Lanes centroid = centroid_of(reference.box);
    const bool is_behind = !((centroid[axis] - low) * bins_per_unit < row);
    *front = reference;
    *behind = reference;
    front += !is_behind;
    behind += is_behind;
    // All bits set are NaN, which adds nothing.
    const std::int32_t bits = -static_cast<std::int32_t>(is_behind);
    const IntLanes mask = {bits, bits, bits, bits};
    const IntLanes of_centroid = std::bit_cast<IntLanes>(centroid);
    extend(spreads[0], std::bit_cast<Lanes>(of_centroid | mask));
    extend(spreads[1], std::bit_cast<Lanes>(of_centroid | ~mask));
  }
  std::copy(scratch, behind, front);
  const std::size_t middle = part.begin + split.first_size;
  sides[0] = {part.begin, middle, part.depth + 1, split.boxes[0], spreads[0]};
  sides[1] = {middle, part.end, part.depth + 1, split.boxes[1], spreads[1]};
}

}  // namespace graze::bvh
