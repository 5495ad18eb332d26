#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/body_shapes/compound_body.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shapes/grown_box.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <typeinfo>
#include <utility>

namespace graze {
namespace {

// Up to this many parts are looked at one by one, which takes less time than to look them up, and
// less memory.
constexpr std::size_t kFew = 16;

}  // namespace

CompoundBody::CompoundBody(const Compound& compound)
    : compound_(compound), numbers_(compound.parts()) {
  if (numbers_.empty()) throw InputError("share: a compound without parts");
  const Eigen::Vector3d most = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  Aabb own{most, -most};
  double deviation = 0;
  std::vector<Aabb> boxes;
  shapes_.resize(numbers_.back() + std::size_t{1});
  for (const std::uint32_t number : numbers_) {
    const PlacedShape& part = compound.part(number);
    shapes_[number] = share(part.shape);
    const Aabb box = bounding_aabb(part);
    deviation = std::max(deviation, rotation_deviation(part.pose));
    own = {own.min.cwiseMin(box.min), own.max.cwiseMax(box.max)};
    boxes.push_back(box);
  }
  set_frame(own, deviation);
  for (Aabb& box : boxes)
    box = grown(box, index_room());
  if (boxes.size() <= kFew) {
    few_boxes_ = std::move(boxes);
    return;
  }
  boxes_ = std::make_unique<BroadPhase>();
  for (const Aabb& box : boxes)
    boxes_->add(box);
  parts_near(own);  // sorts them, once for all threads
}

PartsBody::OwnPart CompoundBody::part(std::uint32_t number) const {
  const std::optional<Filter>& filter = compound_.settings(number).filter;
  return {shapes_[number].get(), compound_.part(number).pose, filter ? &*filter : nullptr};
}

std::vector<std::uint32_t> CompoundBody::parts_near(const Aabb& own_box) const {
  std::vector<std::uint32_t> near;
  if (boxes_) {
    boxes_->find_overlapping(own_box, near);
    std::sort(near.begin(), near.end());
    for (std::uint32_t& place : near)
      place = numbers_[place];
  }
  for (std::size_t place = 0; place < few_boxes_.size(); ++place) {
    if (share_a_point(few_boxes_[place], own_box)) near.push_back(numbers_[place]);
  }
  return near;
}

void CompoundBody::look_at_nearest(const std::optional<Aabb>& own_box, const GapToParts& gap,
                                   double limit, const Look& look) const {
  if (!boxes_) return PartsBody::look_at_nearest(own_box, gap, limit, look);
  std::call_once(tree_flag_, [&] {
    std::vector<Aabb> boxes;
    boxes.reserve(numbers_.size());
    for (const std::uint32_t number : numbers_)
      boxes.push_back(bounding_aabb(compound_.part(number)));
    tree_ = std::make_unique<const PartTree>(boxes);
  });
  const auto look_at = [&](std::uint32_t place) { return look(numbers_[place]); };
  tree_->look_at_nearest(own_box, index_room(), gap, limit, std::cref(look_at));
}

void CompoundBody::visit_along(const Ray& own_ray, const Look& look) const {
  if (!boxes_) {
    for (const std::uint32_t number : numbers_)
      look(number);
    return;
  }
  const auto look_at = [&](std::uint32_t place) { return look(numbers_[place]); };
  boxes_->visit_along(own_ray, std::cref(look_at));  // a reference, so that nothing is allocated
}

void CompoundBody::check_parts(const Pose& pose) const {
  for (const std::uint32_t number : numbers_)
    check_pose(placed_part(pose, compound_.part(number).pose), "pose of a part");
}

const Compound* compound_of(const BodyShape& shape) {
  if (typeid(shape) != typeid(CompoundBody)) return nullptr;
  return &static_cast<const CompoundBody&>(shape).compound();
}

std::shared_ptr<const BodyShape> share(const Compound& compound) {
  return bvh::in_standard_arithmetic([&]() -> std::shared_ptr<const BodyShape> {
    return std::make_shared<CompoundBody>(compound);
  });
}

}  // namespace graze
