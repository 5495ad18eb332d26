#include <graze/bvh/wide/tree/corner_extents.h>
#include <graze/bvh/wide/tree/fit_slabs.h>
#include <graze/bvh/wide/tree/wide_bounds.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

constexpr int kSteepest = 127;

std::int8_t nearest_slope(double slope) {
  const double q = std::sqrt(std::abs(slope) / WideNode::kSlopeUnit);
  const int rounded = static_cast<int>(std::min(q + 0.5, double{kSteepest}));
  return static_cast<std::int8_t>(slope < 0 ? -rounded : rounded);
}

/// Chooses slopes such that the slab stands across the mean normal, as far as slopes go. A normal
/// that lies nearer to another axis makes no slab: the box is as thin along that one.
void choose_slopes(const RangeMoments& moments, const NodeAxes& axes, WideNode& node,
                   std::uint32_t lane) {
  double along[3];
  for (int axis = 0; axis < 3; ++axis) {
    const float* row = axes.rows[axis];
    along[axis] =
        row[0] * moments.normal[0] + row[1] * moments.normal[1] + row[2] * moments.normal[2];
  }
  const bool is_across = std::max(std::abs(along[0]), std::abs(along[1])) < std::abs(along[2]);
  for (int k = 0; k < 2; ++k)
    node.slope[k][lane] = is_across ? nearest_slope(along[k] / along[2]) : std::int8_t{0};
}

/// Slabs that are not so much thinner than boxes cost more than they save.
constexpr double kWorthAsking = 0.85;

/// Sets all of a slab but its slopes.
void set_slab(const CornerRows& rows, const NodeAxes& axes, const float* origin,
              const PrimitiveRange& range, WideNode& node, std::uint32_t lane) {
  const double slope[3] = {WideNode::slope_of(node.slope[0][lane]),
                           WideNode::slope_of(node.slope[1][lane]), 1};
  float direction[1][3] = {};
  double centre = 0;
  double radius = 0;
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    centre += slope[k] * node.centre[k][lane];
    radius += std::abs(slope[k]) * node.half[k][lane];
    size +=
        std::abs(double{origin[k]}) + std::abs(double{node.centre[k][lane]}) + node.half[k][lane];
    direction[0][k] = static_cast<float>(slope[0] * axes.rows[0][k] + slope[1] * axes.rows[1][k] +
                                         slope[2] * axes.rows[2][k]);
  }
  const Interval interval = extent_of(rows, Projection<1>(direction, origin), range)[0];
  const double margin = kFitError * size + kWideUnderflow;
  const double low = (interval.low - margin) - centre;
  const double high = (interval.high + margin) - centre;
  const double middle = 0.5 * (low + high) / (WideNode::kSlabMiddleUnit * radius);
  const double rounded = std::clamp(std::floor(middle + 0.5), -127.0, 127.0);
  const double at = rounded * WideNode::kSlabMiddleUnit * radius;
  const double half = std::max(high - at, at - low) / (WideNode::kSlabHalfUnit * radius);
  // One step more covers the division's rounding. A part of the slab beyond the box does not
  // matter: the box holds all.
  const double steps = std::floor(half) + 1;
  if (!(steps <= 256)) return clear_slab(node, lane);
  node.slab_middle[lane] = static_cast<std::int8_t>(rounded);
  node.slab_half[lane] = static_cast<std::uint8_t>(steps - 1);
}

}  // namespace

void clear_slab(WideNode& node, std::uint32_t lane) {
  node.slope[0][lane] = node.slope[1][lane] = 0;
  node.slab_middle[lane] = 0;
  node.slab_half[lane] = 255;
}

void fit_slabs(const CornerRows& rows, const MomentSums& sums, const NodeAxes& axes,
               const float* origin, std::span<const PrimitiveRange> children, WideNode& node) {
  for (std::uint32_t j = 0; j < node.count; ++j) {
    choose_slopes(sums.of(children[j].begin, children[j].end), axes, node, j);
    set_slab(rows, axes, origin, children[j], node, j);
  }
}

void refit_slabs(const CornerRows& rows, const NodeAxes& axes, const float* origin,
                 std::span<const PrimitiveRange> children, WideNode& node) {
  for (std::uint32_t j = 0; j < node.count; ++j)
    set_slab(rows, axes, origin, children[j], node, j);
}

void choose_slabs(std::span<WideNode> nodes) {
  double boxes = 0;
  double slabs = 0;
  for (const WideNode& node : nodes) {
    for (std::uint32_t j = 0; j < node.count; ++j) {
      const double a = WideNode::slope_of(node.slope[0][j]);
      const double b = WideNode::slope_of(node.slope[1][j]);
      const double radius =
          std::abs(a) * node.half[0][j] + std::abs(b) * node.half[1][j] + node.half[2][j];
      boxes += node.half[2][j];
      slabs +=
          (node.slab_half[j] + 1) * WideNode::kSlabHalfUnit * radius / std::sqrt(a * a + b * b + 1);
    }
  }
  const bool are_worth_asking = slabs < kWorthAsking * boxes;
  for (WideNode& node : nodes)
    node.has_slabs = are_worth_asking;
}

}  // namespace graze::bvh
