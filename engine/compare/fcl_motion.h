#pragma once

// Finds the first contact of two moving shapes with FCL. No type of FCL appears here.

#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/shape.h>

#include <cstddef>
#include <memory>
#include <optional>

namespace graze::compare {

/// Says how FCL looks for a first contact.
enum class FclContinuous {
  Sampled,    ///< its default: poses, evenly spread
  Advanced,   ///< conservative advancement
  Polynomial  ///< vertices on straight paths, for two meshes that do not turn
};

/// Names FCL's kinds of motions. A course is asked as one that goes the same path, or not at all.
enum class FclCourse {
  Interpolated,  ///< InterpMotion, for any course that turns by less than 3 radians
  Screw,  ///< ScrewMotion, for such courses that shift along the axis, and for those that do not
          ///< turn
  Translation,  ///< TranslationMotion, for courses that do not turn
  Spline        ///< SplineMotion, for courses that do not turn, its four points being in line
};

/// Names FCL's searches for nearest points of convex shapes.
enum class FclNearest { Libccd, Independent };

/// Says which shape is FCL's first geometry.
enum class FclOrder { Kept, Swapped };

/// Holds all that a ContinuousCollisionRequest says, with FCL's defaults, but for the kind of
/// motion.
struct FclMotionSettings {
  FclContinuous how = FclContinuous::Sampled;
  FclCourse course = FclCourse::Interpolated;
  FclNearest nearest = FclNearest::Libccd;
  FclOrder order = FclOrder::Kept;
  std::size_t samples = 10;  ///< num_max_iterations
  double time_error =
      1e-4;  ///< toc_err, a share of the time; FCL takes no more than 1 / it samples
};

/// Holds a shape, or a mesh under a tree of OBBs and RSSs, made once for many motions.
class FclMover {
 public:
  explicit FclMover(const Shape& shape);
  ~FclMover();
  FclMover(FclMover&&) noexcept;

 private:
  struct Geometry;
  friend std::optional<struct FclFirstContact> first_contact(const FclMover&, const RigidMotion&,
                                                             const FclMover&, const RigidMotion&,
                                                             const FclMotionSettings&);
  std::unique_ptr<const Geometry> geometry_;
};

/// Holds what FCL says.
struct FclFirstContact {
  bool is_hit;
  double time;  ///< a time from 0 to 1
};

/// Returns FCL's answer. It is nothing for motions that turn by 3 radians or more, for FCL turns
/// the short way, for courses that the kind of motion cannot go, and for shapes that FCL has no
/// such function for. It is nothing either for FCL's advancement of half-spaces and planes, with
/// which FCL 0.7 crashes.
std::optional<FclFirstContact> first_contact(const FclMover& shape_a, const RigidMotion& motion_a,
                                             const FclMover& shape_b, const RigidMotion& motion_b,
                                             const FclMotionSettings& settings);

}  // namespace graze::compare
