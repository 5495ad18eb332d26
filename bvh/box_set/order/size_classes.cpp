#include <graze/bvh/box_set/order/size_classes.h>
#include <graze/bvh/box_set/store/block.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

/// Returns the volume in which 16 of the sample lie, cubic metres: the median of such volumes.
double volume_of_cell(std::span<KdItem> sample) {
  kd_order(sample);
  std::vector<double> volumes;
  for (std::size_t first = 0; first + kLanes <= sample.size(); first += kLanes) {
    double volume = 1;
    for (int c = 0; c < 3; ++c) {
      float low = sample[first].centre[c], high = low;
      for (const KdItem& item : sample.subspan(first, kLanes)) {
        low = std::min(low, item.centre[c]);
        high = std::max(high, item.centre[c]);
      }
      volume *= static_cast<double>(high) - static_cast<double>(low);
    }
    volumes.push_back(volume);
  }
  if (volumes.empty()) return 0;
  const auto middle = volumes.begin() + static_cast<std::ptrdiff_t>(volumes.size() / 2);
  std::nth_element(volumes.begin(), middle, volumes.end());
  return *middle;
}

/// Returns the cube root, rounded, and the same on every machine, which a library's need not be. It
/// is found by Newton's method, from a power of two that is off by a factor of 4 at most.
double cube_root(double x) {
  constexpr int kSteps = 8;
  double root = std::ldexp(1.0, std::ilogb(x) / 3);
  for (int i = 0; i < kSteps; ++i)
    root = (2 * root + x / (root * root)) / 3;
  return root;
}

/// A layer as one cell of space sees it.
struct SharedLayer {
  double side;    ///< metres, of its largest boxes
  double blocks;  ///< how many of its blocks are in the cell
};

/// Returns how many pairs of blocks meet in a cell, of so many cells in all, if blocks lie
/// anywhere: each block is as large as the space that its boxes share, and a box.
double meetings(std::span<const SharedLayer> layers, double cell, double cells) {
  double sum = 0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double side_i = cube_root(cell / layers[i].blocks) + layers[i].side;
    for (std::size_t j = i; j < layers.size(); ++j) {
      const double side = side_i + cube_root(cell / layers[j].blocks) + layers[j].side;
      const double met = std::min(side * side * side / cell, cells);
      sum += layers[i].blocks * layers[j].blocks * (i == j ? met / 2 : met);
    }
  }
  return sum;
}

std::vector<SharedLayer> merged(const std::vector<SharedLayer>& layers, std::size_t i) {
  std::vector<SharedLayer> result = layers;
  result[i] = {std::max(layers[i].side, layers[i + 1].side),
               layers[i].blocks + layers[i + 1].blocks};
  result.erase(result.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  return result;
}

}  // namespace

std::vector<std::size_t> share_layers(std::span<const SizeClass> classes,
                                      std::span<KdItem> sample) {
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < classes.size(); ++i)
    number.push_back(i);
  const double cell = classes.size() < 2 ? 0 : volume_of_cell(sample);
  if (!(cell > 0 && std::isfinite(cell))) return number;
  const std::size_t whole_cells = sample.size() / kLanes;
  const auto cells = static_cast<double>(whole_cells);
  std::vector<SharedLayer> layers;
  for (const SizeClass& of : classes)
    layers.push_back({of.side, static_cast<double>(of.count) / kLanes / cells});
  for (double now = meetings(layers, cell, cells); layers.size() > 1;) {
    std::size_t best = layers.size();
    for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
      const double then = meetings(merged(layers, i), cell, cells);
      if (then < now) now = then, best = i;
    }
    if (best == layers.size()) break;
    layers = merged(layers, best);
    for (std::size_t& of : number)
      of -= of > best;
  }
  return number;
}

}  // namespace graze::bvh
