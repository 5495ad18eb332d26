#pragma once

// Holds shapes and poses as Bullet does, for the adaptors of Bullet alone.

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include <btBulletCollisionCommon.h>
#include <memory>

static_assert(sizeof(btScalar) == sizeof(double), "compile this file with BT_USE_DOUBLE_PRECISION");

namespace graze::compare {

btTransform to_bullet(const Pose& pose);
btVector3 to_bullet(const Eigen::Vector3d& v);
Eigen::Vector3d from_bullet(const btVector3& v);

/// Adds triangles to a mesh, which must stay where it is: a copy of it would point into the first
/// one.
void add_triangles(const Mesh& mesh, btTriangleMesh& triangles);

/// Returns Bullet's shape, with its axis along z and without a margin, but for balls and capsules,
/// whose margin is their radius. Null for ellipsoids, planes of two sides, meshes and height
/// fields.
std::unique_ptr<btCollisionShape> bullet_shape(const Shape& shape);

/// Returns where the frame of that shape is in the frame of the body: Bullet's balls are at 0.
Eigen::Vector3d bullet_centre(const Shape& shape);

}  // namespace graze::compare
