#pragma once

// The BodyShape of several parts: a compound, or a map of voxels. Private to engine/world.

#include <graze/engine/world/body.h>
#include <graze/engine/world/body_shapes/gap_to_parts.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace graze {

/// A part in the world, or a shape without parts that counts as its own part 0.
struct PlacedPart {
  const BodyShape* shape;
  Pose pose;
  Aabb box;              ///< the box that the broad phase would have, but without room
  const Filter* filter;  ///< its own filter, or nullptr
  std::uint32_t number;
};

/// The place at which a ray meets a part, and the number of the part.
struct PartRayHit {
  RayHit hit;
  std::uint32_t part = 0;
};

/// An immutable body of parts. Parts are looked up in the body's own frame by their boxes there, so
/// that a new pose costs nothing for each part; only parts that are found are placed, and then are
/// treated as bodies.
class PartsBody : public BodyShape {
 public:
  /// Returns the parts whose boxes, with room around them, metres, share a point with a box in the
  /// world, except parts that are surely farther than the room from all that is in it; ascending.
  std::vector<PlacedPart> near(const Pose& pose, const Aabb& box, double room) const;
  /// Calls `visit(part)` for the parts that near() returns until it returns false; the rest is not
  /// placed. Returns false then.
  bool visit_near(const Pose& pose, const Aabb& box, double room,
                  const std::function<bool(const PlacedPart&)>& visit) const;
  /// Calls `visit(part)` for parts that may be no farther from the seeker than its limit; `visit`
  /// returns the limit from then on. Where there are many parts they come roughly nearest first.
  void visit_nearest(const Pose& pose, const PartSeeker& seeker,
                     const std::function<double(const PlacedPart&)>& visit) const;
  /// Returns one part, in the world.
  PlacedPart placed(const Pose& pose, std::uint32_t number) const;
  /// Returns a length, metres, such that no part is farther than that from the middle of all parts;
  /// it is larger where the middle is far away from the origin of the frame.
  double extent() const { return extent_; }
  /// Returns where a ray first meets a part. The part's own filter and the given one must let it
  /// meet, if there are both; of equal distances the least number counts.
  std::optional<PartRayHit> first_hit(const Pose& pose, const Ray& ray,
                                      const std::optional<Filter>& filter) const;

  bool allows_concurrent_calls() const override { return true; }
  Aabb bounds(const Pose& pose) const override;
  bool touches(const Pose& pose, const BodyShape& other, const Pose& other_pose) const override;
  Manifold contacts(const Pose& pose, const BodyShape& other,
                    const Pose& other_pose) const override;
  Manifold contacts_within(const Pose& pose, const BodyShape& other, const Pose& other_pose,
                           double margin) const override;
  std::optional<RayHit> cast_ray(const Pose& pose, const Ray& ray) const override;
  RigidContact first_contact(const RigidMotion& motion, const BodyShape& other,
                             const RigidMotion& other_motion,
                             const RigidContactSettings& settings) const override;
  double bounding_radius() const override { return radius_; }

 protected:
  /// A part in the body's own frame.
  struct OwnPart {
    const BodyShape* shape;
    Pose pose;
    const Filter* filter;  ///< its own filter, or nullptr
  };
  /// A function `look(number)` that is called for parts, and returns how far to look from then on.
  using Look = std::function<double(std::uint32_t)>;

  /// Sets a box around the parts in their frame, and the most by which the pose of a part deviates
  /// from a rotation. To be called once, before any question. Throws PoseError if parts reach
  /// beyond kLargestLength.
  void set_frame(const Aabb& own, double deviation);
  /// Returns the room of the boxes by which parts are looked up: it covers the rounding of
  /// own_box() and own_ray(), and the tolerances within which shapes touch.
  double index_room() const;
  const Aabb& own() const { return own_; }

  virtual OwnPart part(std::uint32_t number) const = 0;
  /// Calls `look(number)` for parts that may be no farther than a limit, which `look` returns anew:
  /// for all such parts, or for those whose boxes, with index_room(), share a point with a box of
  /// the own frame.
  virtual void look_at_nearest(const std::optional<Aabb>& own_box, const GapToParts& gap,
                               double limit, const Look& look) const;
  /// Returns the parts whose boxes, with index_room(), share a point with a box of the own frame;
  /// ascending.
  virtual std::vector<std::uint32_t> parts_near(const Aabb& own_box) const = 0;
  virtual std::vector<std::uint32_t> all_parts() const = 0;
  /// Calls `look` for all parts whose boxes, with index_room(), the ray of the own frame meets, and
  /// perhaps for others.
  virtual void visit_along(const Ray& own_ray, const Look& look) const = 0;
  /// Throws PoseError for a pose of the body in which that of a part is refused.
  virtual void check_parts(const Pose& pose) const = 0;

 private:
  BoxPlacing placing(const Pose& pose, double deviation) const;
  std::optional<Aabb> own_box(const Pose& pose, const Aabb& around, const Aabb& whole) const;
  void check_poses_of_parts(const Pose& pose, double deviation) const;
  std::optional<Ray> own_ray(const Pose& pose, const Ray& ray, double& skipped) const;

  Aabb own_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
  double radius_ = 0;  ///< the radius about the frame's origin
  double extent_ = 0;  ///< the radius about the middle, and at least kFarthestShare^-1 of the
                       ///< distance of the middle
  double deviation_ = 0;
};

/// Returns the shape as a body of parts, or nullptr if it is none.
const PartsBody* as_parts(const BodyShape& shape);

/// True if a part's own filter lets it meet a shape with the other filter, or if either is unknown.
bool lets_part_meet(const Filter* part, const std::optional<Filter>& other);

}  // namespace graze
