#pragma once

namespace graze::bvh {

/// Says how a tree's frame lies in the world: p is at (columns, as a matrix) (p - centre)
/// per_metre. A fourth lane, 0, stands for nothing.
struct RayFrame {
  alignas(32) double columns[3][4];
  double centre[3];
  double per_metre;
  double slack;  ///< metres by which what is met may be elsewhere, without what a ray's own numbers
                 ///< round
};

}  // namespace graze::bvh
