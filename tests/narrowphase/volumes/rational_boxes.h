#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>

namespace graze::oracle {

/// How an oriented box {pose {R, t}, h} is read: as t + R y with |y_i| <= h_i, or as the points p
/// with |R^T (p - t)|_i <= h_i.
enum class Reading { Image, Transpose };

/// What the fifteen axes say of two parallelepipeds, in rational arithmetic; no matrix need be a
/// rotation, and there are no other axes that could separate them.
struct Separation {
  bool is_apart;
  /// The largest gap along an axis, metres; negative if they touch. Rounded once or twice.
  double gap;
  /// Likewise, where products of edges are not normalised, but as long as the sine of their angle.
  double sine_gap;
};

Separation separation(const Obb& box_a, const Obb& box_b, Reading read_a, Reading read_b);

/// The axis-aligned box by its exact minimum and maximum.
Separation separation(const Aabb& aligned, const Obb& oriented, Reading read);

}  // namespace graze::oracle
