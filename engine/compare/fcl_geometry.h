#pragma once

// Makes shapes into FCL's geometries, for sources that see FCL's headers anyway.

#include <fcl/geometry/collision_geometry.h>

#include <memory>

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

namespace graze::compare {

struct FclGeometry {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  Eigen::Vector3d centre{0, 0, 0};  ///< FCL's spheres and ellipsoids are at 0
};

/// Returns a shape as FCL's geometry; a mesh is under a tree of OBBs and RSSs.
FclGeometry fcl_geometry(const Shape& shape);

/// Returns where a geometry with that centre goes.
fcl::Transform3d fcl_transform(const Pose& pose, const Eigen::Vector3d& centre);

}  // namespace graze::compare
