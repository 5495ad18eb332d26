#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/voxel_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace graze {
namespace {

/// The largest number of voxels along an axis.
constexpr std::uint32_t kMaxResolution = 65535;

// An index has at most 16 bits: index * edge fits into 52 and is exact, down to the denormals,
// whose last place is 2^-1074.
constexpr int kEdgeBits = 36;
constexpr int kSmallestExponent = -1074;

// Planes one edge apart stay distinct if the edge is at least two units in the last place of the
// larger one: sums that far apart never round to the same double. A plane can lie one binade above
// the largest coordinate M, where the unit is 2^-51 M at most. Sums of denormals are exact.
constexpr double kSmallestEdge = 0x1p-50;

/// Returns the last place of an edge: rounding up goes to a multiple of it.
double edge_quantum(double length) {
  int exponent = 0;
  std::frexp(length, &exponent);
  return std::ldexp(1.0, std::max(exponent - kEdgeBits, kSmallestExponent));
}

double longest_side(const Aabb& bounds) {
  double longest = 0;
  for (int k = 0; k < 3; ++k)
    longest = std::max(longest, bounds.max.data()[k] - bounds.min.data()[k]);
  return longest;
}

double smallest_edge(const Aabb& bounds) {
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    largest = std::max({largest, std::abs(bounds.min.data()[k]), std::abs(bounds.max.data()[k])});
  }
  return std::max(largest * kSmallestEdge, std::numeric_limits<double>::denorm_min());
}

bool is_covered(const VoxelGrid& grid, const Aabb& bounds, int axis, std::uint32_t count) {
  return grid.plane(axis, count) >= bounds.max.data()[axis];
}

bool is_covered(const VoxelGrid& grid, const Aabb& bounds, std::uint32_t count) {
  return is_covered(grid, bounds, 0, count) && is_covered(grid, bounds, 1, count) &&
         is_covered(grid, bounds, 2, count);
}

/// Returns the smallest count that covers the bounds, of which `enough` is one. Planes rise with
/// their index.
std::uint32_t smallest_count(const VoxelGrid& grid, const Aabb& bounds, int axis,
                             std::uint32_t enough) {
  std::uint32_t too_few = 0;
  while (enough - too_few > 1) {
    const std::uint32_t middle = (too_few + enough) / 2;
    (is_covered(grid, bounds, axis, middle) ? enough : too_few) = middle;
  }
  return enough;
}

}  // namespace

VoxelGrid VoxelGrid::over(const Aabb& bounds, std::uint32_t resolution) {
  return bvh::in_standard_arithmetic([&]() -> VoxelGrid {
    check_box(bounds, "voxel grid: bounds");
    if (resolution < 1 || resolution > kMaxResolution) {
      throw InputError("resolution: " + std::to_string(resolution) + " is not from 1 to " +
                       std::to_string(kMaxResolution));
    }
    const double length = std::max(longest_side(bounds) / resolution, smallest_edge(bounds));
    if (!std::isfinite(length)) throw InputError("voxel grid: the length of the bounds overflows");
    const double quantum = edge_quantum(length);
    VoxelGrid grid{bounds.min, std::ceil(length / quantum) * quantum, {1, 1, 1}};
    // The length was rounded three times: at most one step is missing.
    while (!is_covered(grid, bounds, resolution))
      grid.edge += quantum;
    for (int axis = 0; axis < 3; ++axis)
      grid.counts[axis] = smallest_count(grid, bounds, axis, resolution);
    grid.check();
    return grid;
  });
}

double VoxelGrid::plane(int axis, std::uint32_t index) const {
  return bvh::in_standard_arithmetic(
      [&]() -> double { return origin.data()[axis] + index * edge; });
}

Aabb VoxelGrid::box(const Voxel& voxel) const {
  return bvh::in_standard_arithmetic([&]() -> Aabb {
    const std::uint32_t index[3] = {voxel.i, voxel.j, voxel.k};
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      box.min.data()[axis] = plane(axis, index[axis]);
      box.max.data()[axis] = plane(axis, index[axis] + 1);
    }
    return box;
  });
}

void VoxelGrid::check() const {
  bvh::in_standard_arithmetic([&] {
    for (int axis = 0; axis < 3; ++axis) {
      const std::string along = std::string("along ") + "xyz"[axis];
      if (counts[axis] < 1 || counts[axis] > kMaxResolution) {
        throw InputError("voxel grid: " + std::to_string(counts[axis]) + " voxels " + along +
                         ", not from 1 to " + std::to_string(kMaxResolution));
      }
      const double last = plane(axis, counts[axis]);
      if (!std::isfinite(origin.data()[axis]) || !std::isfinite(last)) {
        throw InputError("voxel grid: a plane " + along + " is not finite");
      }
      if (!(plane(axis, 0) < last)) throw InputError("voxel grid: planes do not rise " + along);
    }
  });
}

std::uint64_t VoxelGrid::size() const {
  return std::uint64_t{counts[0]} * counts[1] * counts[2];
}

}  // namespace graze
