#pragma once

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/sphere.h>
#include <graze/bvh/value/local_frame.h>

namespace graze::bvh {

// These return the volumes of a query that is no mesh, as if they were a skin of one node, rounded
// outward.

FloatSphere sphere_around(const FloatBox& box);
FloatObb obb_around(const FloatBox& box);
FloatKDop kdop_around(const FloatBox& box);
FloatKDop kdop_around(const FloatSphere& sphere);

/// Returns the ball in a frame that was made for its box, or for what of it is in the range of
/// double.
FloatSphere to_local(const LocalFrame& frame, const Sphere& sphere);

}  // namespace graze::bvh
