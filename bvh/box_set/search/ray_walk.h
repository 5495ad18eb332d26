#pragma once

#include <graze/bvh/box_set/store/block.h>
#include <graze/bvh/value/ray_slabs.h>

#include <functional>

namespace graze::bvh {

/// Boxes are grown by this share of how far they extend from a ray's origin before they are
/// compared with it: more than answers about the shapes in them are off by.
inline constexpr double kRayPadding = 0x1p-37;

/// Answers entry() for a box that is grown by that.
double padded_entry(const RaySlabs& ray, const double* low, const double* high, double limit);

/// A function that is told of the proxy of a box that the ray may meet; it returns the ray's
/// parameter beyond which no more boxes are of interest.
using RayVisitor = std::function<double(std::uint32_t proxy)>;

/// Visits all boxes that, grown, the ray meets within the limit, roughly from near to far. The
/// limit comes down as the visitor says.
void walk_along(const TreeView& tree, const RaySlabs& ray, double& limit, const RayVisitor& visit);

}  // namespace graze::bvh
