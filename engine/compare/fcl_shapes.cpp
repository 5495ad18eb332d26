#include <graze/engine/compare/fcl_geometry.h>
#include <graze/engine/compare/fcl_shapes.h>

#include <fcl/narrowphase/collision.h>

namespace graze::compare {

namespace {

bool is_flat(ShapeKind kind) {
  return kind == ShapeKind::HalfSpace || kind == ShapeKind::Plane;
}

/// FCL 0.7 calls a function that is not there.
bool is_hull_and_plane(ShapeKind a, ShapeKind b) {
  return a == ShapeKind::ConvexHull && b == ShapeKind::Plane;
}

}  // namespace

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
  if (is_flat(a.kind) && is_flat(b.kind)) return std::nullopt;
  if (is_hull_and_plane(a.kind, b.kind) || is_hull_and_plane(b.kind, a.kind)) return std::nullopt;
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(a.fcl.geometry.get(), fcl_transform(pose_a, a.fcl.centre),
                      b.fcl.geometry.get(), fcl_transform(pose_b, b.fcl.centre), request,
                      result) > 0;
}

}  // namespace graze::compare
