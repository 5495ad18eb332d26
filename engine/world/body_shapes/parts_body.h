#pragma once

// A body of several parts as a world asks it: a compound, or a map of voxels. Private to
// engine/world.

#include <graze/engine/world/body.h>
#include <graze/engine/world/body_shapes/gap_to_parts.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace graze {

/// A part in the world, or a shape that has none and counts as its own part 0.
struct PlacedPart {
  const BodyShape* shape;
  Pose pose;
  Aabb box;              ///< as the broad phase would have it, but without room
  const Filter* filter;  ///< of its own, or nullptr
  std::uint32_t number;
};

/// Where a ray meets a part.
struct PartRayHit {
  RayHit hit;
  std::uint32_t part = 0;
};

/// Immutable. Parts are looked up in the body's own frame by their boxes there, so that a pose
/// costs nothing for each of them; those that are found are placed, and then stand as bodies do.
class PartsBody : public BodyShape {
 public:
  /// Those whose boxes, with room around them, metres, share a point with a box in the world, but
  /// for such that are surely farther from all that is in it; ascending.
  std::vector<PlacedPart> near(const Pose& pose, const Aabb& box, double room) const;
  /// Calls `visit(part)` for these until it returns false: the rest is not placed. False then.
  bool visit_near(const Pose& pose, const Aabb& box, double room,
                  const std::function<bool(const PlacedPart&)>& visit) const;
  /// Calls `visit(part)` for parts that may be no farther from the seeker than its limit: `visit`
  /// says what that is from then on. Where there are many they come roughly nearest first.
  void visit_nearest(const Pose& pose, const PartSeeker& seeker,
                     const std::function<double(const PlacedPart&)>& visit) const;
  /// That part alone, in the world.
  PlacedPart placed(const Pose& pose, std::uint32_t number) const;
  /// No part is farther from the middle of them all, metres, or not much where that is far away
  /// from the origin of the frame.
  double extent() const { return extent_; }
  /// Where a ray meets first a part whose filter, if it has one, and the given one, if there is
  /// one, let it meet; of equal distances the least number.
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
    const Filter* filter;  ///< of its own, or nullptr
  };
  /// What is told of a ray: calls `look(number)` for parts along it, which says how far to look
  /// from then on.
  using Look = std::function<double(std::uint32_t)>;

  /// To be called once, before any question: a box around the parts in their frame, and by how much
  /// the pose of a part deviates from a rotation at most. Throws PoseError for what reaches beyond
  /// kLargestLength.
  void set_frame(const Aabb& own, double deviation);
  /// What own_box() and own_ray() round, and tolerances bring together: boxes have this room.
  double index_room() const;
  const Aabb& own() const { return own_; }

  virtual OwnPart part(std::uint32_t number) const = 0;
  /// Calls `look(number)` for parts that may be no farther than a limit, which `look` returns. All
  /// of them, or those whose boxes, with index_room(), share a point with a box of the own frame.
  virtual void look_at_nearest(const std::optional<Aabb>& own_box, const GapToParts& gap,
                               double limit, const Look& look) const;
  /// Those whose boxes, with index_room(), share a point with a box of the own frame; ascending.
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
  double radius_ = 0;  ///< about the frame's origin
  double extent_ = 0;  ///< about the middle, and at least kFarthestShare^-1 of how far that is
  double deviation_ = 0;
};

/// The shape as one of parts, or nullptr.
const PartsBody* as_parts(const BodyShape& shape);

/// Whether a part's filter of its own lets it meet what has such a filter, where both are known.
bool lets_part_meet(const Filter* part, const std::optional<Filter>& other);

}  // namespace graze
