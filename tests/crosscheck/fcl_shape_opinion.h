#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include <memory>

namespace graze::tests {

/// What FCL says of two placed shapes. It knows no pair of half-spaces, and none with a mesh on
/// both sides is asked here.
struct FclOpinion {
  bool is_hit;
  double depth;     ///< of the deepest contact; 0 without
  double distance;  ///< 0 or less for hits; not asked, and 0, where FCL has no answer: half-spaces
};

/// Two placed shapes as FCL's objects, made once so that questions alone can be timed.
class FclPair {
 public:
  FclPair(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);
  ~FclPair();
  FclPair(FclPair&&) noexcept;

  bool intersects() const;  ///< without contacts
  FclOpinion contacts() const;
  double distance() const;  ///< not for half-spaces: FCL 0.7 would crash

 private:
  struct Objects;
  std::unique_ptr<Objects> objects_;
};

/// FCL's default solver, which is built on libccd, at a distance tolerance of 1e-10.
FclOpinion ask_fcl(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

}  // namespace graze::tests
