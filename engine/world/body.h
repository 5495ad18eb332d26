#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/ids.h>
#include <graze/engine/world/manifold.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace graze {

/// The questions that a world asks of a shape. Shapes are immutable and may be shared by bodies and
/// threads. share() makes one of any Shape; users may derive their own classes, if these can tell
/// whether they touch the other shapes of the world.
class BodyShape {
 public:
  virtual ~BodyShape() = default;

  /// Returns the Shape that this one stands for, or nullptr if it is a user's own.
  virtual const Shape* shape() const { return nullptr; }

  /// True if several threads may ask the shape at once, as a world with WorldSettings::threads
  /// does. A shape that returns false is asked only by the thread that calls World::update(). A
  /// world asks this once, before a body takes the shape.
  virtual bool allows_concurrent_calls() const { return false; }

  /// Returns a box in world coordinates, metres, that holds the shape placed by the pose.
  virtual Aabb bounds(const Pose& pose) const = 0;

  /// True if the placed shapes share a point. A world asks the body with the smaller index; a
  /// Shape that meets a user's own asks that one instead.
  virtual bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const = 0;

  /// Returns the contacts of two shapes that touch, with this one as A. A world asks the same one
  /// of the two as it does for touches(). By default the manifold is empty.
  virtual Manifold contacts(const Pose& pose, const BodyShape& other, const Pose& other_pose) const;

  /// Returns the contacts of two shapes that touch or are apart by no more than a margin above 0,
  /// metres; the manifold is empty if they are farther apart. A world asks the same one of the two
  /// as it does for touches(). By default margins are ignored: the answer is contacts() where the
  /// two touch.
  virtual Manifold contacts_within(const Pose& pose, const BodyShape& other, const Pose& other_pose,
                                   double margin) const;

  /// Returns contacts() where touches() is true, else nothing: both questions in one. The poses
  /// must have been checked, as those of a world have been.
  virtual std::optional<Manifold> meet(const Pose& pose, const BodyShape& other,
                                       const Pose& other_pose) const;

  /// Returns a lower bound of the distance, metres: as long as the two have come nearer to each
  /// other, since these poses, by less than that, touches() stays false. It is 0 where nothing is
  /// known, or where asking touches() again costs less than this does.
  virtual double gap(const Pose& pose, const BodyShape& other, const Pose& other_pose) const;

  /// Returns where a ray meets the shape first, at most ray.max_distance away. By default it throws
  /// UnsupportedPairError.
  virtual std::optional<RayHit> cast_ray(const Pose& pose, const Ray& ray) const;

  /// Returns when this shape first meets another while both move: see first_contact() of shapes. A
  /// world asks it for bodies that are swept (Detection), and the same one of the two as for
  /// touches(). By default nothing is known, and the answer is Close from time 0 on.
  virtual RigidContact first_contact(const RigidMotion& motion, const BodyShape& other,
                                     const RigidMotion& other_motion,
                                     const RigidContactSettings& settings) const;

  /// Returns a length, metres, such that no point of the shape is further than that from its
  /// frame's origin; it is infinite if none is known.
  virtual double bounding_radius() const;
};

/// Makes a BodyShape of a Shape, for World::add(). Many bodies may share it.
std::shared_ptr<const BodyShape> share(const Shape& shape);

/// A user's own shape, or a shape that bodies share, in a pose.
struct PlacedBodyShape {
  std::shared_ptr<const BodyShape> shape;  ///< not nullptr
  Pose pose = Pose::Identity();            ///< the pose of the shape
};

/// Says who moves a body, and which bodies it can meet.
enum class BodyKind : std::uint8_t {
  Static,     ///< the body does not move by itself; it meets only dynamic bodies
  Kinematic,  ///< the user moves the body, as rails would; it meets only dynamic bodies
  Dynamic     ///< a solver moves the body; it meets all others
};

/// The times at which an update looks at a body.
enum class Detection : std::uint8_t {
  Discrete,   ///< the update looks at the body's place now
  Continuous  ///< the update looks at the body's place now and at its whole motion since the last
              ///< update: the body is swept, so that nothing that it meets is too thin to be found
};

/// Says what it means to meet a body.
enum class Role : std::uint8_t {
  Solid,  ///< the body meets others as its kind says
  Sensor  ///< the body meets solid bodies that are dynamic or kinematic, whatever its own kind is,
          ///< and neither static bodies nor other sensors; its pairs have no contacts
};

/// Says which bodies may meet. Two bodies may meet if each one's category has a bit in the other's
/// mask. Two of the same group other than 0 may meet if the group is positive, and may not if it is
/// negative, whatever the masks say.
struct Filter {
  std::uint32_t category = 1;        ///< the categories that the body is in, one bit each
  std::uint32_t mask = 0xffffffffu;  ///< the categories that the body meets, one bit each
  std::int32_t group = 0;            ///< if 0, categories and masks decide

  bool operator==(const Filter&) const = default;
};

/// True if two bodies with these filters may meet.
bool lets_pass(const Filter& a, const Filter& b);

}  // namespace graze
