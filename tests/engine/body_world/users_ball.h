#pragma once

#include <graze/engine/world/world.h>

#include <memory>

namespace graze::tests {

/// A ball of a user's own, which may note who asks it.
class UsersBall : public BodyShape {
 public:
  explicit UsersBall(double radius, bool is_concurrent = false)
      : inner_(share(Sphere{{0, 0, 0}, radius})), is_concurrent_(is_concurrent) {}

  bool allows_concurrent_calls() const override { return is_concurrent_; }
  Aabb bounds(const Pose& pose) const override { return inner_->bounds(pose); }
  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    note();
    return inner_->touches(pose, inner_of(other), other_pose);
  }
  Manifold contacts(const Pose& pose, const BodyShape& other,
                    const Pose& other_pose) const override {
    note();
    return inner_->contacts(pose, inner_of(other), other_pose);
  }
  double gap(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    note();
    return inner_->gap(pose, inner_of(other), other_pose);
  }
  double bounding_radius() const override { return inner_->bounding_radius(); }

 protected:
  virtual void note() const {}

 private:
  static const BodyShape& inner_of(const BodyShape& other) {
    const auto* ball = dynamic_cast<const UsersBall*>(&other);
    return ball == nullptr ? other : *ball->inner_;
  }

  std::shared_ptr<const BodyShape> inner_;
  bool is_concurrent_;
};

}  // namespace graze::tests
