#include <graze/engine/compare/peers/bullet_geometry.h>

#include <variant>

namespace graze::compare {
namespace {

struct MakeBulletShape {
  std::unique_ptr<btCollisionShape> operator()(const Sphere& s) const {
    return std::make_unique<btSphereShape>(s.radius);
  }
  std::unique_ptr<btCollisionShape> operator()(const Box& s) const {
    return std::make_unique<btBoxShape>(to_bullet(s.half_extents));
  }
  std::unique_ptr<btCollisionShape> operator()(const Capsule& s) const {
    return std::make_unique<btCapsuleShapeZ>(s.radius, 2 * s.half_length);
  }
  std::unique_ptr<btCollisionShape> operator()(const Cylinder& s) const {
    return std::make_unique<btCylinderShapeZ>(btVector3(s.radius, s.radius, s.half_height));
  }
  std::unique_ptr<btCollisionShape> operator()(const Cone& s) const {
    return std::make_unique<btConeShapeZ>(s.radius, 2 * s.half_height);
  }
  std::unique_ptr<btCollisionShape> operator()(const ConvexHull& s) const {
    auto hull = std::make_unique<btConvexHullShape>();
    for (std::size_t i = 0; i < s.vertex_count(); ++i)
      hull->addPoint(to_bullet(s.vertex(i)), false);
    hull->recalcLocalAabb();
    return hull;
  }
  std::unique_ptr<btCollisionShape> operator()(const HalfSpace& s) const {
    return std::make_unique<btStaticPlaneShape>(to_bullet(s.normal), s.offset);
  }
  std::unique_ptr<btCollisionShape> operator()(const Plane&) const { return nullptr; }
  std::unique_ptr<btCollisionShape> operator()(const Ellipsoid&) const { return nullptr; }
  std::unique_ptr<btCollisionShape> operator()(const Mesh&) const { return nullptr; }
  std::unique_ptr<btCollisionShape> operator()(const HeightField&) const { return nullptr; }
};

}  // namespace

btTransform to_bullet(const Pose& pose) {
  return btTransform(btMatrix3x3(pose(0, 0), pose(0, 1), pose(0, 2), pose(1, 0), pose(1, 1),
                                 pose(1, 2), pose(2, 0), pose(2, 1), pose(2, 2)),
                     btVector3(pose(0, 3), pose(1, 3), pose(2, 3)));
}

btVector3 to_bullet(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

Eigen::Vector3d from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

void add_triangles(const Mesh& mesh, btTriangleMesh& triangles) {
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = mesh.triangle(i);
    triangles.addTriangle({t.a.x(), t.a.y(), t.a.z()}, {t.b.x(), t.b.y(), t.b.z()},
                          {t.c.x(), t.c.y(), t.c.z()});
  }
}

std::unique_ptr<btCollisionShape> bullet_shape(const Shape& shape) {
  std::unique_ptr<btCollisionShape> made = std::visit(MakeBulletShape(), shape.value());
  const bool is_round = shape.kind() == ShapeKind::Sphere || shape.kind() == ShapeKind::Capsule;
  if (made && !is_round) made->setMargin(0);
  return made;
}

Eigen::Vector3d bullet_centre(const Shape& shape) {
  const auto* ball = shape.as<Sphere>();
  return ball != nullptr ? ball->centre : Eigen::Vector3d(0, 0, 0);
}

}  // namespace graze::compare
