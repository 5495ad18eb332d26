#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/body_shapes/compound_body.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shapes/grown_box.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <typeinfo>
#include <utility>

namespace graze {
namespace {

// Boxes in the compound's frame have room of 2^-16 of its radius r, so that a box or a ray that was
// taken into that frame still meets what it met before. Let u be 2^-53.
// - A point and a body of which no coordinate is above kFarthestShare r are taken there by 9
//   roundings of what is below 2^31 r: off by less than 2^-18 r. So are middles of boxes.
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

// So many are looked at one by one, which takes less than to look them up, and less memory.
constexpr std::size_t kFew = 16;

// As bounds of shapes have it (shape_bounds.cpp), and what placing rounds.
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

/// R^T v.
Eigen::Vector3d turned_back(const Pose& pose, const Eigen::Vector3d& v) {
  const double* m = pose.data();  // column-major 4x4
  Eigen::Vector3d back;
  for (int i = 0; i < 3; ++i)
    back.data()[i] = (m[4 * i] * v.x() + m[4 * i + 1] * v.y()) + m[4 * i + 2] * v.z();
  return back;
}

/// A box around the box of the world in the frame of the pose.
Aabb taken_back(const Pose& pose, const Aabb& box) {
  const double* m = pose.data();
  const Eigen::Vector3d middle = turned_back(pose, box.min / 2 + box.max / 2 - pose.translation());
  const Eigen::Vector3d half = box.max / 2 - box.min / 2;
  Eigen::Vector3d reach;
  for (int i = 0; i < 3; ++i) {
    reach.data()[i] = (std::abs(m[4 * i]) * half.x() + std::abs(m[4 * i + 1]) * half.y()) +
                      std::abs(m[4 * i + 2]) * half.z();
  }
  return {middle - reach, middle + reach};
}

}  // namespace

CompoundBody::CompoundBody(const Compound& compound) : compound_(compound) {
  if (compound.size() == 0) throw InputError("share: a compound without parts");
  const Eigen::Vector3d most = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  own_ = {most, -most};
  std::vector<Aabb> boxes;
  for (const std::uint32_t number : compound.parts()) {
    const PlacedShape& part = compound.part(number);
    slots_.push_back({share(part.shape), number});
    const Aabb box = bounding_aabb(part);
    deviation_ = std::max(deviation_, rotation_deviation(part.pose));
    own_ = {own_.min.cwiseMin(box.min), own_.max.cwiseMax(box.max)};
    boxes.push_back(box);
  }
  radius_ = radius_of(own_);
  if (!(radius_ <= kLargestLength))
    throw PoseError("share: the compound reaches beyond the largest length");
  for (Aabb& box : boxes)
    box = grown(box, kIndexRoom * radius_);
  if (boxes.size() <= kFew) {
    few_boxes_ = std::move(boxes);
    return;
  }
  boxes_ = std::make_unique<BroadPhase>();
  for (const Aabb& box : boxes)
    boxes_->add(box);
  slots_near(own_);  // sorts them, once for all threads
}

/// Ascending.
std::vector<std::uint32_t> CompoundBody::slots_near(const Aabb& own_box) const {
  std::vector<std::uint32_t> slots;
  if (boxes_) {
    boxes_->find_overlapping(own_box, slots);
    std::sort(slots.begin(), slots.end());
  }
  for (std::uint32_t slot = 0; slot < few_boxes_.size(); ++slot) {
    if (share_a_point(few_boxes_[slot], own_box)) slots.push_back(slot);
  }
  return slots;
}

/// The sum of the deviations, at most three times that of the body for each entry, or each part.
void CompoundBody::check_poses_of_parts(const Pose& pose, double deviation) const {
  const double most = (3 * deviation + deviation_) + (0x20p-53 + 3 * deviation * deviation_);
  const bool is_near = largest_of(pose.translation()) + radius_ <= kLargestLength / 2;
  if (most <= kMaxRotationDeviation && is_near) return;
  for (const Slot& slot : slots_)
    check_pose(placed_part(pose, compound_.part(slot.number).pose), "pose of a part");
}

Aabb CompoundBody::bounds(const Pose& pose) const {
  return bvh::in_standard_arithmetic([&]() -> Aabb {
    const double deviation = check_pose(pose, "pose");
    check_poses_of_parts(pose, deviation);
    const double* m = pose.data();
    Aabb box;
    for (int i = 0; i < 3; ++i) {
      double low = m[12 + i], high = m[12 + i];
      for (int j = 0; j < 3; ++j) {
        const double at_min = m[4 * j + i] * own_.min.data()[j];
        const double at_max = m[4 * j + i] * own_.max.data()[j];
        low += std::min(at_min, at_max);
        high += std::max(at_min, at_max);
      }
      box.min.data()[i] = low;
      box.max.data()[i] = high;
    }
    const double size = radius_ + largest_of(pose.translation());
    return grown(box, kBoundsShare * size + 2 * kReadings * (deviation + deviation_) * radius_);
  });
}

PlacedPart CompoundBody::placed(const Pose& pose, std::uint32_t slot) const {
  const auto& [shape, number] = slots_[slot];
  const Pose of_part = placed_part(pose, compound_.part(number).pose);
  const std::optional<Filter>& filter = compound_.settings(number).filter;
  return {shape.get(), of_part, shape->bounds(of_part), filter ? &*filter : nullptr, number};
}

std::vector<PlacedPart> CompoundBody::near(const Pose& pose, const Aabb& box, double room) const {
  const Aabb around = room > 0 ? grown(box, room) : box;
  const Aabb whole = bounds(pose);
  if (!share_a_point(around, whole)) return {};
  // Of what is far larger than the compound only what is near it need be taken into its frame.
  const bool is_known = width_of(around) <= kLargestShare * radius_ &&
                        largest_of(pose.translation()) <= kFarthestShare * radius_ &&
                        rotation_deviation(pose) <= kSmallDeviation;
  std::vector<std::uint32_t> slots;
  if (is_known) {
    const Aabb common{around.min.cwiseMax(whole.min), around.max.cwiseMin(whole.max)};
    slots = slots_near(taken_back(pose, common));
  }
  std::vector<PlacedPart> parts;
  for (std::uint32_t i = 0; i < (is_known ? slots.size() : slots_.size()); ++i) {
    PlacedPart part = placed(pose, is_known ? slots[i] : i);
    if (share_a_point(room > 0 ? grown(part.box, room) : part.box, box)) parts.push_back(part);
  }
  return parts;
}

/// The part of a ray from where it comes near the compound, in the compound's frame, and how much
/// of it lies before that; nothing if that is not known well enough to look parts up.
std::optional<Ray> CompoundBody::own_ray(const Pose& pose, const Ray& ray, double& skipped) const {
  const Eigen::Vector3d way = pose.translation() - ray.origin;
  if (!(largest_of(pose.translation()) <= kFarthestShare * radius_ &&
        largest_of(way) <= kFarthestRay * radius_ && rotation_deviation(pose) <= kSmallDeviation)) {
    return std::nullopt;
  }
  // Scaled first, as squares could overflow.
  const Eigen::Vector3d scaled = ray.direction / largest_of(ray.direction);
  const Eigen::Vector3d unit =
      scaled /
      std::sqrt((scaled.x() * scaled.x() + scaled.y() * scaled.y()) + scaled.z() * scaled.z());
  const double along = (way.x() * unit.x() + way.y() * unit.y()) + way.z() * unit.z();
  skipped = std::max(along - 1.125 * radius_, 0.0);
  return Ray{turned_back(pose, skipped * unit - way), turned_back(pose, unit),
             std::max(ray.max_distance - skipped, 0.0) + kIndexRoom * radius_};
}

std::optional<PartRayHit> CompoundBody::first_hit(const Pose& pose, const Ray& ray,
                                                  const std::optional<Filter>& filter) const {
  std::optional<PartRayHit> first;
  Ray shorter = ray;
  const auto ask = [&](std::uint32_t slot) {
    const auto& [shape, number] = slots_[slot];
    const std::optional<Filter>& own = compound_.settings(number).filter;
    if (!lets_part_meet(own ? &*own : nullptr, filter)) return;
    const auto hit = shape->cast_ray(placed_part(pose, compound_.part(number).pose), shorter);
    if (!hit || (first && hit->distance == first->hit.distance && number > first->part)) return;
    first = {*hit, number};
    shorter.max_distance = hit->distance;
  };
  double skipped = 0;
  const std::optional<Ray> own = boxes_ ? own_ray(pose, ray, skipped) : std::nullopt;
  if (!own) {
    for (std::uint32_t slot = 0; slot < slots_.size(); ++slot)
      ask(slot);
    return first;
  }
  const auto look = [&](std::uint32_t slot) {
    return bvh::in_standard_arithmetic([&] {
      ask(slot);
      return std::max(shorter.max_distance - skipped, 0.0) + kIndexRoom * radius_;
    });
  };
  boxes_->visit_along(*own, std::cref(look));  // a reference: nothing is allocated
  return first;
}

const CompoundBody* as_compound(const BodyShape& shape) {
  return typeid(shape) == typeid(CompoundBody) ? static_cast<const CompoundBody*>(&shape) : nullptr;
}

const Compound* compound_of(const BodyShape& shape) {
  const CompoundBody* compound = as_compound(shape);
  return compound == nullptr ? nullptr : &compound->compound();
}

bool lets_part_meet(const Filter* part, const std::optional<Filter>& other) {
  return part == nullptr || !other || lets_pass(*part, *other);
}

std::shared_ptr<const BodyShape> share(const Compound& compound) {
  return bvh::in_standard_arithmetic([&]() -> std::shared_ptr<const BodyShape> {
    return std::make_shared<CompoundBody>(compound);
  });
}

}  // namespace graze
