// What a world asks of a Shape, answered by the table of all pairs.

#include <graze/engine/world/body.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>

#include <utility>

namespace graze {
namespace {

Manifold mirrored(Manifold manifold) {
  for (std::size_t i = 0; i < manifold.count; ++i) {
    ShapeContact& contact = manifold.contacts[i];
    contact.normal = -contact.normal;
    std::swap(contact.feature.a, contact.feature.b);
  }
  return manifold;
}

class ShapeBody final : public BodyShape {
 public:
  explicit ShapeBody(const Shape& shape) : shape_(shape) {}

  const Shape* shape() const override { return &shape_; }

  Aabb bounds(const Pose& pose) const override { return bounds_of(shape_, pose); }

  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    const Shape* shape = other.shape();
    if (shape == nullptr) return other.touches(other_pose, *this, pose);
    return intersects(shape_, pose, *shape, other_pose);
  }

  Manifold contacts(const Pose& pose, const BodyShape& other,
                    const Pose& other_pose) const override {
    const Shape* shape = other.shape();
    if (shape == nullptr) return mirrored(other.contacts(other_pose, *this, pose));
    // No finite translation parts two half-spaces: they touch, and have no contact.
    if (pair_method(shape_.kind(), shape->kind()) == PairMethod::Planes) return {};
    return find_contacts(shape_, pose, *shape, other_pose);
  }

 private:
  Shape shape_;
};

}  // namespace

Manifold BodyShape::contacts(const Pose& /*pose*/, const BodyShape& /*other*/,
                             const Pose& /*other_pose*/) const {
  return {};
}

std::shared_ptr<const BodyShape> share(const Shape& shape) {
  return std::make_shared<ShapeBody>(shape);
}

}  // namespace graze
