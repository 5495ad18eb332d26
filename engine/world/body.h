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

/// What a world asks of a shape. Shapes are immutable and may be shared by bodies and threads.
/// share() makes one of any Shape; a user's own class may stand beside those, if it can tell
/// whether it touches them.
class BodyShape {
 public:
  virtual ~BodyShape() = default;

  /// The Shape that it stands for, or nullptr if it is a user's own.
  virtual const Shape* shape() const { return nullptr; }

  /// Whether several threads may ask the shape at once, as a world with WorldSettings::threads
  /// does. One that does not say so is asked only by the thread that calls World::update(). A world
  /// asks this once, before a body takes the shape.
  virtual bool allows_concurrent_calls() const { return false; }

  /// A box in world coordinates, metres, that holds the shape placed by the pose.
  virtual Aabb bounds(const Pose& pose) const = 0;

  /// True if the placed shapes share a point. A world asks the body with the smaller index; a
  /// Shape that meets a user's own asks that one instead.
  virtual bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const = 0;

  /// Where two that touch meet, as seen from this one; asked as touches() is. A shape that does not
  /// know offers none.
  virtual Manifold contacts(const Pose& pose, const BodyShape& other, const Pose& other_pose) const;

  /// Where two meet that touch or are apart by no more than a margin above 0, metres: empty if they
  /// are farther apart. Asked as touches() is; by default, of a shape that does not know of
  /// margins, contacts() of those that touch.
  virtual Manifold contacts_within(const Pose& pose, const BodyShape& other, const Pose& other_pose,
                                   double margin) const;

  /// Both in one: what contacts() says where touches() is true, else nothing. For poses that have
  /// been checked, as those of a world have.
  virtual std::optional<Manifold> meet(const Pose& pose, const BodyShape& other,
                                       const Pose& other_pose) const;

  /// A lower bound of the distance, metres: as long as the two come nearer to each other than in
  /// these poses by less than that, touches() stays false. 0 where nothing is known, or where to
  /// ask touches() again costs less than this does.
  virtual double gap(const Pose& pose, const BodyShape& other, const Pose& other_pose) const;

  /// Where a ray meets it first, at most ray.max_distance away. A shape that does not know throws
  /// UnsupportedPairError.
  virtual std::optional<RayHit> cast_ray(const Pose& pose, const Ray& ray) const;

  /// When it meets another, both in motion: see first_contact() of shapes. Asked as touches() is,
  /// for bodies that are swept (Detection). A shape that does not know says so: Close from 0 on.
  virtual RigidContact first_contact(const RigidMotion& motion, const BodyShape& other,
                                     const RigidMotion& other_motion,
                                     const RigidContactSettings& settings) const;

  /// No point of the shape is further than this from its frame's origin, metres; infinite if not
  /// known.
  virtual double bounding_radius() const;
};

/// A Shape as a world asks it, for World::add(): one for many bodies.
std::shared_ptr<const BodyShape> share(const Shape& shape);

/// A user's own shape, or one that bodies share, in a pose.
struct PlacedBodyShape {
  std::shared_ptr<const BodyShape> shape;  ///< not nullptr
  Pose pose = Pose::Identity();            ///< of the shape
};

/// Who moves a body, and whom it can meet.
enum class BodyKind : std::uint8_t {
  Static,     ///< does not move by itself; meets only dynamic bodies
  Kinematic,  ///< is moved by its user, as by rails; meets only dynamic bodies
  Dynamic     ///< is moved by a solver; meets all
};

/// At which times an update looks at a body.
enum class Detection : std::uint8_t {
  Discrete,   ///< where it is now
  Continuous  ///< where it is now, and all along its motion since the last update: it is swept, so
              ///< that nothing that it meets is too thin to be found
};

/// What meeting a body means.
enum class Role : std::uint8_t {
  Solid,  ///< meets other bodies as its kind says
  Sensor  ///< is told of solid bodies that are dynamic or kinematic, whatever its own kind is, and
          ///< neither of static bodies nor of other sensors; its pairs have no contacts
};

/// Who meets whom. Two bodies may meet if each one's category has a bit in the other's mask. Two of
/// the same group other than 0 may meet if the group is positive, and may not if it is negative,
/// whatever the masks say.
struct Filter {
  std::uint32_t category = 1;        ///< bits: what the body is
  std::uint32_t mask = 0xffffffffu;  ///< bits: which categories it meets
  std::int32_t group = 0;            ///< 0: categories and masks decide
};

/// Whether two bodies with these filters can meet.
bool lets_pass(const Filter& a, const Filter& b);

}  // namespace graze
