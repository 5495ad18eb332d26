#include <graze/bvh/local_frame.h>
#include <graze/bvh/wide/fit_node.h>
#include <graze/bvh/wide/node_axes.h>
#include <graze/bvh/wide/wide_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::bvh {
namespace {

constexpr std::size_t kChunk = 64;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Interval {
  float low = kInfinity;
  float high = -kInfinity;
};

/// Where the children of one node lie along three axes, from an origin.
struct ChildExtents {
  Interval along[WideNode::kWidth][3];
};

float smaller(float a, float b) {
  return a < b ? a : b;
}
float larger(float a, float b) {
  return a > b ? a : b;
}

/// Along one axis, the extents of `count` primitives from `first` on.
void project(const CornerRows& rows, const float* axis, const float* origin, std::size_t first,
             std::size_t count, float* low, float* high) {
  const float* x[3];
  const float* y[3];
  const float* z[3];
  for (std::size_t c = 0; c < 3; ++c) {
    x[c] = rows.row(c, 0) + first;
    y[c] = rows.row(c, 1) + first;
    z[c] = rows.row(c, 2) + first;
  }
  for (std::size_t i = 0; i < count; ++i) {
    float along[3];
    for (std::size_t c = 0; c < 3; ++c) {
      along[c] = (axis[0] * (x[c][i] - origin[0]) + axis[1] * (y[c][i] - origin[1])) +
                 axis[2] * (z[c][i] - origin[2]);
    }
    low[i] = smaller(smaller(along[0], along[1]), along[2]);
    high[i] = larger(larger(along[0], along[1]), along[2]);
  }
}

ChildExtents extents_along(const CornerRows& rows, const NodeAxes& axes, const float* origin,
                           std::span<const PrimitiveRange> children) {
  ChildExtents extents;
  float low[kChunk], high[kChunk];
  std::size_t child = 0;
  const std::size_t end = children.back().end;
  for (std::size_t first = children.front().begin; first < end; first += kChunk) {
    const std::size_t count = std::min(kChunk, end - first);
    const std::size_t first_child = child;
    for (int k = 0; k < 3; ++k) {
      project(rows, axes.rows[k], origin, first, count, low, high);
      child = first_child;
      for (std::size_t i = 0; i < count; ++i) {
        while (first + i >= children[child].end)
          ++child;
        Interval& interval = extents.along[child][k];
        interval.low = smaller(interval.low, low[i]);
        interval.high = larger(interval.high, high[i]);
      }
    }
  }
  return extents;
}

float sum_of_surfaces(const ChildExtents& extents, std::size_t children) {
  float sum = 0;
  for (std::size_t j = 0; j < children; ++j) {
    const Interval(&e)[3] = extents.along[j];
    const float x = e[0].high - e[0].low;
    const float y = e[1].high - e[1].low;
    const float z = e[2].high - e[2].low;
    sum += x * y + y * z + z * x;
  }
  return sum;
}

/// The middle of the corners' box, roughly: any point near by will do.
void choose_origin(const RangeMoments& moments, std::size_t primitives, float* origin) {
  for (int k = 0; k < 3; ++k)
    origin[k] = static_cast<float>(moments.sum[k] / (3.0 * static_cast<double>(primitives)));
}

void set_boxes(const ChildExtents& extents, const float* origin, WideNode& node) {
  for (std::size_t j = 0; j < node.count; ++j) {
    float size = std::abs(origin[0]) + std::abs(origin[1]) + std::abs(origin[2]);
    float half[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval& interval = extents.along[j][k];
      node.centre[k][j] = 0.5f * interval.low + 0.5f * interval.high;
      half[k] = larger(interval.high - node.centre[k][j], node.centre[k][j] - interval.low);
      size += half[k] + std::abs(node.centre[k][j]);
    }
    const float margin = kFitError * size + kWideUnderflow;
    for (std::size_t k = 0; k < 3; ++k)
      node.half[k][j] = rounded_up(double{half[k]} + margin);
  }
}

void clear_empty_lanes(WideNode& node) {
  for (std::size_t j = node.count; j < WideNode::kWidth; ++j) {
    node.child[j] = 0;
    for (std::size_t k = 0; k < 3; ++k)
      node.centre[k][j] = node.half[k][j] = 0;
  }
}

}  // namespace

void fit_node(const CornerRows& rows, const MomentSums& sums,
              std::span<const PrimitiveRange> children, const double (&rows_origin)[3],
              WideNode& node) {
  const std::size_t begin = children.front().begin;
  const std::size_t end = children.back().end;
  node.count = static_cast<std::uint32_t>(children.size());
  const RangeMoments moments = sums.of(begin, end);
  float origin[3];
  choose_origin(moments, end - begin, origin);
  for (int k = 0; k < 3; ++k)
    node.origin[k] = rows_origin[k] + origin[k];
  NodeAxes axes = axes_of(moments, 3 * (end - begin));
  ChildExtents extents = extents_along(rows, axes, origin, children);
  const ChildExtents aligned = extents_along(rows, kCoordinateAxes, origin, children);
  if (!(sum_of_surfaces(extents, node.count) < sum_of_surfaces(aligned, node.count))) {
    axes = kCoordinateAxes;
    extents = aligned;
  }
  for (int k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis)
      node.axes[k][axis] = axes.rows[axis][k];
    node.axes[k][3] = 0;
  }
  set_boxes(extents, origin, node);
  clear_empty_lanes(node);
}

}  // namespace graze::bvh
