#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/body_shapes/compound_body.h>
#include <graze/engine/world/body_shapes/parts_body.h>
#include <graze/engine/world/body_shapes/voxel_body.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shapes/grown_box.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <typeinfo>

namespace graze {
namespace {

// Boxes in the body's frame have room of 2^-16 of its extent r, so that a box or a ray that was
// taken into that frame still meets what it met before. Let u be 2^-53. The frame is taken as one
// about the middle c of the parts, of which no coordinate is above kFarthestShare r, by definition.
// - Of a point and a body no coordinate is above kFarthestShare r either: the middle is placed by 6
//   roundings of what is below 2^31 r, and parts by as many, off by less than 2^-19 r each. That
//   the rest rounds, of what is about as far from the middle as the parts, is less than 2^-23 r.
// - A pose that deviates by at most kSmallDeviation from a rotation adds 4 times that share of r
//   (kReadings of shape_bounds.cpp): 2^-20 r.
// - Shapes that are apart by less than kTouchTolerance of their scale may touch. The other's box
//   being no wider than kLargestShare r, the scale is below 2 (r + sqrt(3) 2^12 r) < 2^14 r, and
//   each coordinate is off by less than 2^-20 r.
// - A ray meets shapes whose faces are elsewhere by 2^-40 of a scale, which is at most 2^20 r for
//   what begins at most kFarthestRay r away: 2^-20 r.
// The sum is below 2^-17 r, and the rest is for the boxes of the parts themselves.
constexpr double kIndexRoom = 0x1p-16;
constexpr double kFarthestShare = 0x1p28;
constexpr double kSmallDeviation = 0x1p-22;
constexpr double kLargestShare = 0x1p12;
constexpr double kFarthestRay = 0x1p19;

// The errors of the bounds of shapes (shape_bounds.cpp), and of placing.
constexpr double kBoundsShare = 0x200p-53;
constexpr double kReadings = 4;

double largest_of(const Eigen::Vector3d& v) {
  return std::max(std::abs(v.x()), std::max(std::abs(v.y()), std::abs(v.z())));
}

double radius_of(const Aabb& box) {
  Eigen::Vector3d far;
  for (int i = 0; i < 3; ++i)
    far.data()[i] = std::max(std::abs(box.min.data()[i]), std::abs(box.max.data()[i]));
  return std::sqrt((far.x() * far.x() + far.y() * far.y()) + far.z() * far.z()) * (1 + 0x8p-53);
}

/// Returns R^T v.
Eigen::Vector3d turned_back(const Pose& pose, const Eigen::Vector3d& v) {
  const double* m = pose.data();  // column-major 4x4
  Eigen::Vector3d back;
  for (int i = 0; i < 3; ++i)
    back.data()[i] = (m[4 * i] * v.x() + m[4 * i + 1] * v.y()) + m[4 * i + 2] * v.z();
  return back;
}

/// Takes a point of the body's frame to the world.
Eigen::Vector3d placed_point(const Pose& pose, const Eigen::Vector3d& p) {
  const double* m = pose.data();
  Eigen::Vector3d at;
  for (int i = 0; i < 3; ++i)
    at.data()[i] = ((m[i] * p.x() + m[4 + i] * p.y()) + m[8 + i] * p.z()) + m[12 + i];
  return at;
}

/// Takes a box of the world to the frame of the pose: returns a box around it, computed about a
/// point of that frame.
Aabb taken_back(const Pose& pose, const Eigen::Vector3d& about, const Aabb& box) {
  const double* m = pose.data();
  const Eigen::Vector3d away = box.min / 2 + box.max / 2 - placed_point(pose, about);
  const Eigen::Vector3d middle = about + turned_back(pose, away);
  const Eigen::Vector3d half = box.max / 2 - box.min / 2;
  Eigen::Vector3d half_there;
  for (int i = 0; i < 3; ++i) {
    half_there.data()[i] = (std::abs(m[4 * i]) * half.x() + std::abs(m[4 * i + 1]) * half.y()) +
                           std::abs(m[4 * i + 2]) * half.z();
  }
  return {middle - half_there, middle + half_there};
}

}  // namespace

void PartsBody::set_frame(const Aabb& own, double deviation) {
  own_ = own;
  deviation_ = deviation;
  radius_ = radius_of(own);
  if (!(radius_ <= kLargestLength))
    throw PoseError("share: the parts reach beyond the largest length");
  middle_ = own.min / 2 + own.max / 2;
  extent_ = std::max(radius_of({own.min - middle_, own.max - middle_}),
                     largest_of(middle_) / kFarthestShare);
}

double PartsBody::index_room() const {
  return kIndexRoom * extent_;
}

/// Checks the poses of parts: all at once by a bound for the sum of the deviations, in which that
/// of the body counts three times, or else each part.
void PartsBody::check_poses_of_parts(const Pose& pose, double deviation) const {
  const double most = (3 * deviation + deviation_) + (0x20p-53 + 3 * deviation * deviation_);
  const bool is_near = largest_of(pose.translation()) + radius_ <= kLargestLength / 2;
  if (most > kMaxRotationDeviation || !is_near) check_parts(pose);
}

Aabb PartsBody::bounds(const Pose& pose) const {
  return bvh::in_standard_arithmetic([&]() -> Aabb {
    const double deviation = check_pose(pose, "pose");
    check_poses_of_parts(pose, deviation);
    return placing(pose, deviation)(own_);
  });
}

/// Returns how to place boxes. Boxes of parts are within the placed box around them, too.
BoxPlacing PartsBody::placing(const Pose& pose, double deviation) const {
  const double size = radius_ + largest_of(pose.translation());
  return {pose, kBoundsShare * size + 2 * kReadings * (deviation + deviation_) * radius_};
}

PlacedPart PartsBody::placed(const Pose& pose, std::uint32_t number) const {
  const OwnPart own = part(number);
  const Pose of_part = placed_part(pose, own.pose);
  return {own.shape, of_part, own.shape->bounds(of_part), own.filter, number};
}

std::vector<PlacedPart> PartsBody::near(const Pose& pose, const Aabb& box, double room) const {
  std::vector<PlacedPart> parts;
  visit_near(pose, box, room, [&](const PlacedPart& part) {
    parts.push_back(part);
    return true;
  });
  return parts;
}

/// Returns the part of a box in the world that may be near the parts, in the body's frame, or
/// nothing if that is not known well enough to look parts up. Of a box that is far larger than the
/// body only the part near it need be taken there.
std::optional<Aabb> PartsBody::own_box(const Pose& pose, const Aabb& around,
                                       const Aabb& whole) const {
  const bool is_known = width_of(around) <= kLargestShare * extent_ &&
                        largest_of(pose.translation()) <= kFarthestShare * extent_ &&
                        rotation_deviation(pose) <= kSmallDeviation;
  if (!is_known) return std::nullopt;
  return taken_back(pose, middle_,
                    {around.min.cwiseMax(whole.min), around.max.cwiseMin(whole.max)});
}

bool PartsBody::visit_near(const Pose& pose, const Aabb& box, double room,
                           const std::function<bool(const PlacedPart&)>& visit) const {
  const Aabb around = room > 0 ? grown(box, room) : box;
  const Aabb whole = bounds(pose);
  if (!share_a_point(around, whole)) return true;
  const std::optional<Aabb> own = own_box(pose, around, whole);
  for (const std::uint32_t number : own ? parts_near(*own) : all_parts()) {
    const PlacedPart part = placed(pose, number);
    if (share_a_point(room > 0 ? grown(part.box, room) : part.box, box) && !visit(part))
      return false;
  }
  return true;
}

void PartsBody::visit_nearest(const Pose& pose, const PartSeeker& seeker,
                              const std::function<double(const PlacedPart&)>& visit) const {
  const Aabb around = grown(seeker.box, seeker.search_radius);
  const Aabb whole = bounds(pose);
  if (!share_a_point(around, whole)) return;
  const GapToParts gap(seeker, placing(pose, rotation_deviation(pose)), 2 * extent_);
  double limit = seeker.limit;
  const auto look = [&](std::uint32_t number) {
    const PlacedPart part = placed(pose, number);
    if (gap.to_box(part.box) <= limit) limit = visit(part);
    return limit;
  };
  look_at_nearest(own_box(pose, around, whole), gap, limit, std::cref(look));
}

void PartsBody::look_at_nearest(const std::optional<Aabb>& own_box, const GapToParts&, double,
                                const Look& look) const {
  for (const std::uint32_t number : own_box ? parts_near(*own_box) : all_parts())
    look(number);
}

/// Returns the part of a ray from where it comes near the body, in the body's frame, and how much
/// of it lies before that, or nothing if that is not known well enough to look parts up.
std::optional<Ray> PartsBody::own_ray(const Pose& pose, const Ray& ray, double& skipped) const {
  const Eigen::Vector3d offset = placed_point(pose, middle_) - ray.origin;
  if (!(largest_of(pose.translation()) <= kFarthestShare * extent_ &&
        largest_of(offset) <= kFarthestRay * extent_ &&
        rotation_deviation(pose) <= kSmallDeviation)) {
    return std::nullopt;
  }
  // The direction is scaled first, as squares could overflow.
  const Eigen::Vector3d scaled = ray.direction / largest_of(ray.direction);
  const Eigen::Vector3d unit =
      scaled /
      std::sqrt((scaled.x() * scaled.x() + scaled.y() * scaled.y()) + scaled.z() * scaled.z());
  const double along = (offset.x() * unit.x() + offset.y() * unit.y()) + offset.z() * unit.z();
  skipped = std::max(along - 1.125 * extent_, 0.0);
  return Ray{middle_ + turned_back(pose, skipped * unit - offset), turned_back(pose, unit),
             std::max(ray.max_distance - skipped, 0.0) + index_room()};
}

std::optional<PartRayHit> PartsBody::first_hit(const Pose& pose, const Ray& ray,
                                               const std::optional<Filter>& filter) const {
  std::optional<PartRayHit> first;
  Ray shorter = ray;
  const auto ask = [&](std::uint32_t number) {
    const OwnPart own = part(number);
    if (!lets_part_meet(own.filter, filter)) return;
    const auto hit = own.shape->cast_ray(placed_part(pose, own.pose), shorter);
    if (!hit || (first && hit->distance == first->hit.distance && number > first->part)) return;
    first = {*hit, number};
    shorter.max_distance = hit->distance;
  };
  double skipped = 0;
  const std::optional<Ray> own = own_ray(pose, ray, skipped);
  if (!own) {
    for (const std::uint32_t number : all_parts())
      ask(number);
    return first;
  }
  const auto look = [&](std::uint32_t number) {
    return bvh::in_standard_arithmetic([&] {
      ask(number);
      return std::max(shorter.max_distance - skipped, 0.0) + index_room();
    });
  };
  visit_along(*own, std::cref(look));  // a reference, so that nothing is allocated
  return first;
}

const PartsBody* as_parts(const BodyShape& shape) {
  const std::type_info& type = typeid(shape);
  if (type != typeid(CompoundBody) && type != typeid(VoxelBody)) return nullptr;
  return static_cast<const PartsBody*>(&shape);
}

bool lets_part_meet(const Filter* part, const std::optional<Filter>& other) {
  return part == nullptr || !other || lets_pass(*part, *other);
}

}  // namespace graze
