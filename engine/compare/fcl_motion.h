#pragma once

// The first contact of two moving shapes, as FCL finds it. No type of FCL appears here.

#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/shape.h>

#include <memory>
#include <optional>

namespace graze::compare {

/// How FCL looks for a first contact.
enum class FclContinuous {
  Sampled,  ///< its default: ten poses, evenly spread
  Advanced  ///< conservative advancement
};

/// A shape, or a mesh under a tree of OBBs and RSSs, made once for many motions.
class FclMover {
 public:
  explicit FclMover(const Shape& shape);
  ~FclMover();
  FclMover(FclMover&&) noexcept;

 private:
  struct Geometry;
  friend std::optional<struct FclFirstContact> first_contact(const FclMover&, const RigidMotion&,
                                                             const FclMover&, const RigidMotion&,
                                                             FclContinuous);
  std::unique_ptr<const Geometry> geometry_;
};

/// What FCL says.
struct FclFirstContact {
  bool is_hit;
  double time;  ///< from 0 to 1
};

/// FCL's answer, with its defaults but for how it looks. Its InterpMotion goes as a RigidMotion
/// does, but turns the short way: nothing of motions that turn by 3 radians or more. Nothing either
/// of shapes that it has no such function for, and of its advancement of half-spaces and planes,
/// with which FCL 0.7 crashes.
std::optional<FclFirstContact> first_contact(const FclMover& shape_a, const RigidMotion& motion_a,
                                             const FclMover& shape_b, const RigidMotion& motion_b,
                                             FclContinuous how);

}  // namespace graze::compare
