#include <graze/engine/compare/fcl_geometry.h>
#include <graze/engine/compare/fcl_shapes.h>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <limits>

namespace graze::compare {

namespace {

bool is_flat(ShapeKind kind) {
  return kind == ShapeKind::HalfSpace || kind == ShapeKind::Plane;
}

bool is_hull_and_plane(ShapeKind a, ShapeKind b) {
  return a == ShapeKind::ConvexHull && b == ShapeKind::Plane;
}

}  // namespace

bool fcl_knows(ShapeKind a, ShapeKind b) {
  return !(is_flat(a) && is_flat(b)) && !is_hull_and_plane(a, b) && !is_hull_and_plane(b, a);
}

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
  if (!fcl_knows(a.kind, b.kind)) return std::nullopt;
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(a.fcl.geometry.get(), fcl_transform(pose_a, a.fcl.centre),
                      b.fcl.geometry.get(), fcl_transform(pose_b, b.fcl.centre), request,
                      result) > 0;
}

std::optional<double> distance(const FclShape& shape_a, const Pose& pose_a, const FclShape& shape_b,
                               const Pose& pose_b) {
  const FclShape::Geometry& a = *shape_a.geometry_;
  const FclShape::Geometry& b = *shape_b.geometry_;
  if (is_flat(a.kind) || is_flat(b.kind)) return std::nullopt;
  const fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  fcl::distance(a.fcl.geometry.get(), fcl_transform(pose_a, a.fcl.centre), b.fcl.geometry.get(),
                fcl_transform(pose_b, b.fcl.centre), request, result);
  const bool is_found = result.min_distance != std::numeric_limits<double>::max();
  return is_found ? std::optional(result.min_distance) : std::nullopt;
}

std::optional<std::vector<FclContact>> find_contacts(const FclShape& shape_a, const Pose& pose_a,
                                                     const FclShape& shape_b, const Pose& pose_b) {
  const FclShape::Geometry& a = *shape_a.geometry_;
  const FclShape::Geometry& b = *shape_b.geometry_;
  if (!fcl_knows(a.kind, b.kind)) return std::nullopt;
  const fcl::CollisionRequestd request(std::numeric_limits<std::size_t>::max(),
                                       /*enable_contact=*/true);
  fcl::CollisionResultd result;
  fcl::collide(a.fcl.geometry.get(), fcl_transform(pose_a, a.fcl.centre), b.fcl.geometry.get(),
               fcl_transform(pose_b, b.fcl.centre), request, result);
  std::vector<FclContact> contacts;
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    const fcl::Contactd& contact = result.getContact(i);
    contacts.push_back({contact.pos, contact.normal, contact.penetration_depth});
  }
  return contacts;
}

}  // namespace graze::compare
