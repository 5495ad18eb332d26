#include <graze/engine/compare/fcl_geometry.h>
#include <graze/engine/compare/fcl_shapes.h>

#include <fcl/narrowphase/collision.h>

namespace graze::compare {

struct FclShape::Geometry {
  FclGeometry fcl;
  ShapeKind kind;
};

FclShape::FclShape(const Shape& shape)
    : geometry_(std::make_unique<Geometry>(Geometry{fcl_geometry(shape), shape.kind()})) {
  geometry_->fcl.geometry->computeLocalAABB();
}
FclShape::~FclShape() = default;
FclShape::FclShape(FclShape&&) noexcept = default;

std::optional<bool> intersects(const FclShape& shape_a, const Pose& pose_a, const FclShape& shape_b,
                               const Pose& pose_b) {
  const FclShape::Geometry& a = *shape_a.geometry_;
  const FclShape::Geometry& b = *shape_b.geometry_;
  if (a.kind == ShapeKind::HalfSpace && b.kind == ShapeKind::HalfSpace) return std::nullopt;
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(a.fcl.geometry.get(), fcl_transform(pose_a, a.fcl.centre),
                      b.fcl.geometry.get(), fcl_transform(pose_b, b.fcl.centre), request,
                      result) > 0;
}

}  // namespace graze::compare
