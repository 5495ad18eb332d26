#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/sphere.h>

namespace graze {

/// The surface of a ball alone: the points at exactly `radius` from `centre`.
struct HollowSphere {
  Sphere sphere;  ///< the ball whose surface it is
};

/// The surface of a box alone. The surface of a flat box is the whole box.
struct HollowAabb {
  Aabb box;  ///< the box whose surface it is
};

}  // namespace graze
