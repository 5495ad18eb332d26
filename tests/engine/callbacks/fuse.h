#pragma once

// What a user hands to graze to be called back, and what throws when its turn has come.

#include <graze/engine/world/world.h>

#include <atomic>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

namespace graze::tests {

/// Not a graze::Error: what graze has never heard of must come through as well.
struct Burnt : std::runtime_error {
  explicit Burnt(long call) : std::runtime_error("burnt at call " + std::to_string(call)) {}
};

/// Counts the calls of all that holds it, and throws once, at the chosen one.
class Fuse {
 public:
  static constexpr long kNever = std::numeric_limits<long>::max();

  void burn() {
    const long call = ++calls_;
    long due = due_.load();
    if (call >= due && due_.compare_exchange_strong(due, kNever)) throw Burnt(call);
  }

  /// Throws at the n-th call from now on, counted from 1.
  void light(long n) { due_ = calls_ + n; }
  void douse() { due_ = kNever; }
  bool is_lit() const { return due_ != kNever; }
  long calls() const { return calls_; }

 private:
  std::atomic<long> calls_ = 0;
  std::atomic<long> due_ = kNever;
};

/// A shape as graze makes it, behind a fuse at each of its doors. A transparent one may be asked by
/// several threads at once.
class FusedShape final : public BodyShape {
 public:
  enum class Look { Opaque, Transparent };  // whether shape() tells what it stands for

  FusedShape(const Shape& shape, std::shared_ptr<Fuse> fuse, Look look)
      : inner_(share(shape)), fuse_(std::move(fuse)), look_(look) {
    ++living();
  }
  ~FusedShape() override { --living(); }
  FusedShape(const FusedShape&) = delete;
  FusedShape& operator=(const FusedShape&) = delete;

  /// How many there are, so that none is lost.
  static std::atomic<long>& living() {
    static std::atomic<long> count = 0;
    return count;
  }

  const Shape* shape() const override {
    fuse_->burn();
    return look_ == Look::Transparent ? inner_->shape() : nullptr;
  }
  bool allows_concurrent_calls() const override {
    fuse_->burn();
    return look_ == Look::Transparent;
  }
  Aabb bounds(const Pose& pose) const override {
    fuse_->burn();
    return inner_->bounds(pose);
  }
  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    fuse_->burn();
    return inner_->touches(pose, inner_of(other), other_pose);
  }
  Manifold contacts(const Pose& pose, const BodyShape& other,
                    const Pose& other_pose) const override {
    fuse_->burn();
    return inner_->contacts(pose, inner_of(other), other_pose);
  }
  std::optional<Manifold> meet(const Pose& pose, const BodyShape& other,
                               const Pose& other_pose) const override {
    fuse_->burn();
    return inner_->meet(pose, inner_of(other), other_pose);
  }
  double gap(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override {
    fuse_->burn();
    return inner_->gap(pose, inner_of(other), other_pose);
  }
  std::optional<RayHit> cast_ray(const Pose& pose, const Ray& ray) const override {
    fuse_->burn();
    return inner_->cast_ray(pose, ray);
  }
  double bounding_radius() const override {
    fuse_->burn();
    return inner_->bounding_radius();
  }

 private:
  static const BodyShape& inner_of(const BodyShape& other) {
    const auto* fused = dynamic_cast<const FusedShape*>(&other);
    return fused == nullptr ? other : *fused->inner_;
  }

  std::shared_ptr<const BodyShape> inner_;
  std::shared_ptr<Fuse> fuse_;
  Look look_;
};

}  // namespace graze::tests
