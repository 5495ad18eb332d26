#include <graze/bvh/sah_split.h>

#include <algorithm>
#include <array>

namespace graze::bvh {
namespace {

constexpr int kBins = 16;

/// Few references need few bins: most nodes are near the leaves, where sweeping would cost the
/// most.
int bin_count(std::size_t references) {
  return references <= 4 ? 4 : references <= 16 ? 8 : kBins;
}

/// Centroids closer together than this, in local units, are one: dividing by less could overflow.
constexpr float kSmallestSpread = 1e-30f;

/// Half surfaces below this underflow when they are split further.
constexpr float kSmallestSurface = 1e-30f;

struct Bin {
  FloatBox box;
  std::uint32_t count;
};

struct Spread {
  float low[3];
  float high[3];
};

Spread spread_of_centroids(std::span<const Reference> references) {
  Spread spread;
  for (int k = 0; k < 3; ++k) {
    spread.low[k] = spread.high[k] = references[0].centroid(k);
  }
  for (const Reference& reference : references) {
    for (int k = 0; k < 3; ++k) {
      const float centroid = reference.centroid(k);
      spread.low[k] = std::min(spread.low[k], centroid);
      spread.high[k] = std::max(spread.high[k], centroid);
    }
  }
  return spread;
}

int bin_of(float centroid, float low, float bins_per_unit, int bins) {
  return std::min(bins - 1, static_cast<int>((centroid - low) * bins_per_unit));
}

/// Primitives on one line have no surface that could tell splits apart: their length does.
enum class Measure { Surface, Length };

float measured(const FloatBox& box, Measure measure) {
  if (measure == Measure::Surface) return half_surface(box);
  return (box.max[0] - box.min[0]) + (box.max[1] - box.min[1]) + (box.max[2] - box.min[2]);
}

/// Lowers `best` to the cheapest plane between these bins of one axis that has bins on both sides.
void sweep(std::span<const Bin> bins, Split candidate, Measure measure, Split& best) {
  std::array<float, kBins> cost_behind;
  std::array<std::uint32_t, kBins> count_behind;
  FloatBox box = empty_box();
  std::uint32_t count = 0;
  const int last = static_cast<int>(bins.size()) - 1;
  for (int i = last; i > 0; --i) {
    box = merged(box, bins[i].box);
    count += bins[i].count;
    cost_behind[i] = count == 0 ? 0 : measured(box, measure) * static_cast<float>(count);
    count_behind[i] = count;
  }
  box = empty_box();
  count = 0;
  for (int i = 1; i <= last; ++i) {
    box = merged(box, bins[i - 1].box);
    count += bins[i - 1].count;
    if (count == 0 || count_behind[i] == 0) continue;
    candidate.bin = i;
    candidate.cost = measured(box, measure) * static_cast<float>(count) + cost_behind[i];
    if (best.axis < 0 || candidate.cost < best.cost) best = candidate;
  }
}

}  // namespace

FloatBox bounds_of(std::span<const Reference> references) {
  FloatBox box = references[0].box;
  for (const Reference& reference : references)
    box = merged(box, reference.box);
  return box;
}

Split find_sah_split(std::span<const Reference> references, const FloatBox& box) {
  const Measure measure = half_surface(box) > kSmallestSurface ? Measure::Surface : Measure::Length;
  const Spread spread = spread_of_centroids(references);
  const int count = bin_count(references.size());
  Bin bins[3][kBins];
  for (auto& axis : bins)
    std::fill_n(axis, count, Bin{empty_box(), 0});
  float bins_per_unit[3];
  for (int k = 0; k < 3; ++k) {
    const float width = spread.high[k] - spread.low[k];
    bins_per_unit[k] = width > kSmallestSpread ? static_cast<float>(count) / width : 0;
  }
  for (const Reference& reference : references) {
    for (int k = 0; k < 3; ++k) {
      Bin& bin = bins[k][bin_of(reference.centroid(k), spread.low[k], bins_per_unit[k], count)];
      bin.box = merged(bin.box, reference.box);
      ++bin.count;
    }
  }
  Split best;
  for (int k = 0; k < 3; ++k) {
    if (bins_per_unit[k] > 0)
      sweep({bins[k], static_cast<std::size_t>(count)}, {k, 0, spread.low[k], bins_per_unit[k], 0},
            measure, best);
  }
  best.cost /= measured(box, measure);
  return best;
}

std::size_t partition_at(std::span<Reference> references, const Split& split) {
  const int count = bin_count(references.size());
  const auto middle = std::partition(references.begin(), references.end(), [&](const Reference& r) {
    return bin_of(r.centroid(split.axis), split.low, split.bins_per_unit, count) < split.bin;
  });
  return static_cast<std::size_t>(middle - references.begin());
}

std::size_t partition_in_halves(std::span<Reference> references) {
  const Spread spread = spread_of_centroids(references);
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (spread.high[k] - spread.low[k] > spread.high[axis] - spread.low[axis]) axis = k;
  }
  const std::size_t half = references.size() / 2;
  std::nth_element(references.begin(), references.begin() + static_cast<std::ptrdiff_t>(half),
                   references.end(), [axis](const Reference& a, const Reference& b) {
                     const float ca = a.centroid(axis);
                     const float cb = b.centroid(axis);
                     return ca != cb ? ca < cb : a.index < b.index;
                   });
  return half;
}

}  // namespace graze::bvh
