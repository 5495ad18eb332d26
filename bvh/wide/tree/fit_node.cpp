#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/wide/tree/corner_extents.h>
#include <graze/bvh/wide/tree/fit_node.h>
#include <graze/bvh/wide/tree/fit_slabs.h>
#include <graze/bvh/wide/tree/node_axes.h>
#include <graze/bvh/wide/tree/wide_bounds.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

/// The extents of the children of one node.
struct ChildExtents {
  Extent<3> of[WideNode::kWidth];
};

ChildExtents extents_along(const CornerRows& rows, const NodeAxes& axes, const float* origin,
                           std::span<const PrimitiveRange> children) {
  const Projection<3> onto(axes.rows, origin);
  ChildExtents extents;
  for (std::size_t j = 0; j < children.size(); ++j)
    extents.of[j] = extent_of(rows, onto, children[j]);
  return extents;
}

float surface_of(const Extent<3>& extent) {
  const float x = extent[0].high - extent[0].low;
  const float y = extent[1].high - extent[1].low;
  const float z = extent[2].high - extent[2].low;
  return x * y + y * z + z * x;
}

float sum_of_surfaces(const ChildExtents& extents, std::size_t children) {
  float sum = 0;
  for (std::size_t j = 0; j < children; ++j)
    sum += surface_of(extents.of[j]);
  return sum;
}

/// Chooses roughly the middle of the corners' box: any point near by will do.
void choose_origin(const RangeMoments& moments, std::size_t primitives, float* origin) {
  for (int k = 0; k < 3; ++k)
    origin[k] = static_cast<float>(moments.sum[k] / (3.0 * static_cast<double>(primitives)));
}

void set_boxes(const ChildExtents& extents, const float* origin, WideNode& node) {
  for (std::size_t j = 0; j < node.count; ++j) {
    float size = std::abs(origin[0]) + std::abs(origin[1]) + std::abs(origin[2]);
    float half[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval& interval = extents.of[j][k];
      node.centre[k][j] = 0.5f * interval.low + 0.5f * interval.high;
      half[k] = std::max(interval.high - node.centre[k][j], node.centre[k][j] - interval.low);
      size += half[k] + std::abs(node.centre[k][j]);
    }
    const float margin = kFitError * size + kWideUnderflow;
    for (std::size_t k = 0; k < 3; ++k)
      node.half[k][j] = rounded_up(double{half[k]} + margin);
  }
}

void clear_empty_lanes(WideNode& node) {
  for (std::uint32_t j = node.count; j < WideNode::kWidth; ++j) {
    node.child[j] = 0;
    clear_slab(node, j);
    for (std::size_t k = 0; k < 3; ++k)
      node.centre[k][j] = node.half[k][j] = 0;
  }
}

}  // namespace

float fit_node(const CornerRows& rows, const MomentSums& sums,
               std::span<const PrimitiveRange> children, const double (&rows_origin)[3],
               WideNode& node) {
  const std::size_t begin = children.front().begin;
  const std::size_t end = children.back().end;
  node.count = static_cast<std::uint16_t>(children.size());
  const RangeMoments moments = sums.of(begin, end);
  float origin[3];
  choose_origin(moments, end - begin, origin);
  for (int k = 0; k < 3; ++k)
    node.origin[k] = rows_origin[k] + origin[k];
  NodeAxes axes = axes_of(moments, 3 * (end - begin));
  ChildExtents extents = extents_along(rows, axes, origin, children);
  const ChildExtents aligned = extents_along(rows, kCoordinateAxes, origin, children);
  float surfaces = sum_of_surfaces(extents, node.count);
  const float of_aligned = sum_of_surfaces(aligned, node.count);
  if (!(surfaces < of_aligned)) {
    axes = kCoordinateAxes;
    extents = aligned;
    surfaces = of_aligned;
  }
  for (int k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis)
      node.axes[k][axis] = axes.rows[axis][k];
  }
  set_boxes(extents, origin, node);
  fit_slabs(rows, sums, axes, origin, children, node);
  clear_empty_lanes(node);
  return surfaces;
}

float refit_node(const CornerRows& rows, std::span<const PrimitiveRange> children,
                 const double (&rows_origin)[3], WideNode& node) {
  // This is a corner of the primitive in the middle: any point near by will do.
  const std::size_t middle = (children.front().begin + children.back().end) / 2;
  float origin[3];
  NodeAxes axes;
  for (std::size_t k = 0; k < 3; ++k) {
    origin[k] = rows.row(0, k)[middle];
    node.origin[k] = rows_origin[k] + origin[k];
    for (std::size_t axis = 0; axis < 3; ++axis)
      axes.rows[axis][k] = node.axes[k][axis];
  }
  const ChildExtents extents = extents_along(rows, axes, origin, children);
  set_boxes(extents, origin, node);
  refit_slabs(rows, axes, origin, children, node);
  return sum_of_surfaces(extents, node.count);
}

}  // namespace graze::bvh
