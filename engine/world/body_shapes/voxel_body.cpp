#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/body_shapes/voxel_body.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shapes/grown_box.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <typeinfo>

namespace graze {
namespace {

constexpr std::uint32_t kSideOfBlock = VoxelMap::kBlock;
constexpr std::uint32_t kVoxelsOfBlock = kSideOfBlock * kSideOfBlock * kSideOfBlock;

/// A share of the largest coordinate: a plane is off by one rounding, a middle by two, its box by
/// another, and the bounds of a box have as much room again.
constexpr double kPlaneShare = 0x8p-53;

/// Returns a box around the part of a ray within a box. Its rounding is far less than index_room().
Aabb box_along(const Ray& ray, const Aabb& box) {
  double from = 0, to = ray.max_distance;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction.data()[axis], o = ray.origin.data()[axis];
    if (d == 0) continue;
    const double s = (box.min.data()[axis] - o) / d, t = (box.max.data()[axis] - o) / d;
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  to = std::max(to, from);
  const Eigen::Vector3d a = ray.origin + from * ray.direction, b = ray.origin + to * ray.direction;
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

}  // namespace

VoxelBody::VoxelBody(const VoxelMap& map) : map_(map), box_(share(map.box())) {
  if (map.empty()) throw InputError("share: a map without voxels");
  const Eigen::Vector3d most = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  Aabb own{most, -most};
  for (std::uint32_t place = 0; place < map_.blocks_.size(); ++place) {
    if (map_.blocks_[place].count == 0) continue;
    const Aabb box = *box_of(map_.blocks_[place], {});
    own = {own.min.cwiseMin(box.min), own.max.cwiseMax(box.max)};
    places_.push_back(place);
    boxes_.push_back(box);
  }
  set_frame(own, 0);
  for (const Aabb& box : boxes_)
    blocks_.add(grown(box, index_room()));
  parts_near({own.min, own.min});  // sorts them, once for all threads
}

/// Returns a box around the full voxels of a cube, if there are any, with room for the rounding of
/// the boxes of voxels.
std::optional<Aabb> VoxelBody::box_of(const VoxelMap::Block& block, const BlockCube& cube) const {
  const VoxelGrid& grid = map_.grid();
  const unsigned mask = ((1u << cube.side) - 1) << cube.x;
  unsigned bits[3] = {0, 0, 0};
  for (std::uint32_t z = cube.z; z < cube.z + cube.side; ++z) {
    for (std::uint32_t y = cube.y; y < cube.y + cube.side; ++y) {
      const unsigned row = block.rows[z * kSideOfBlock + y] & mask;
      if (row == 0) continue;
      bits[0] |= row;
      bits[1] |= 1u << y;
      bits[2] |= 1u << z;
    }
  }
  if (bits[0] == 0) return std::nullopt;
  Aabb box;
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t corner = corner_of(block, axis);
    box.min.data()[axis] =
        grid.plane(axis, corner + static_cast<std::uint32_t>(std::countr_zero(bits[axis])));
    box.max.data()[axis] =
        grid.plane(axis, corner + static_cast<std::uint32_t>(std::bit_width(bits[axis])));
    largest = std::max({largest, std::abs(box.min.data()[axis]), std::abs(box.max.data()[axis])});
  }
  return grown(box, kPlaneShare * largest);
}

/// Returns the least index of the voxels of a block along an axis.
std::uint32_t VoxelBody::corner_of(const VoxelMap::Block& block, int axis) {
  return static_cast<std::uint32_t>(block.key >> 16 * axis & 0xffff) * kSideOfBlock;
}

PartsBody::OwnPart VoxelBody::part(std::uint32_t number) const {
  return {box_.get(), map_.pose(number), nullptr};
}

/// Calls `visit(number)` for the full voxels of a block whose boxes, with index_room(), share a
/// point with a box, or nearly do; ascending.
template <typename Visit>
void VoxelBody::for_voxels_in(std::uint32_t place, const Aabb& own_box, const Visit& visit) const {
  const VoxelMap::Block& block = map_.blocks_[place];
  const VoxelGrid& grid = map_.grid();
  // The rounding of planes and middles is far less than the room; 2^-16 of an edge is for the
  // quotient, which matters between -1 and 17.
  std::uint32_t low[3], high[3];
  const double room = index_room();
  for (int axis = 0; axis < 3; ++axis) {
    const double corner = grid.plane(axis, corner_of(block, axis));
    const double from = (own_box.min.data()[axis] - room - corner) / grid.edge - 0x1p-16;
    const double to = (own_box.max.data()[axis] + room - corner) / grid.edge + 0x1p-16;
    if (!(from < kSideOfBlock) || !(to >= 0)) return;
    low[axis] = from > 0 ? static_cast<std::uint32_t>(from) : 0;
    high[axis] = to < kSideOfBlock - 1 ? static_cast<std::uint32_t>(to) : kSideOfBlock - 1;
  }
  for (std::uint32_t z = low[2]; z <= high[2]; ++z) {
    for (std::uint32_t y = low[1]; y <= high[1]; ++y) {
      const std::uint32_t row = z * kSideOfBlock + y;
      for (std::uint32_t x = low[0]; x <= high[0]; ++x) {
        if ((block.rows[row] >> x & 1) != 0) visit(place * kVoxelsOfBlock + row * kSideOfBlock + x);
      }
    }
  }
}

std::vector<std::uint32_t> VoxelBody::parts_near(const Aabb& own_box) const {
  std::vector<std::uint32_t> blocks;
  blocks_.find_overlapping(own_box, blocks);
  std::sort(blocks.begin(), blocks.end());
  std::vector<std::uint32_t> near;
  for (const std::uint32_t block : blocks)
    for_voxels_in(places_[block], own_box, [&](std::uint32_t number) { near.push_back(number); });
  return near;
}

std::vector<std::uint32_t> VoxelBody::all_parts() const {
  std::vector<std::uint32_t> all;
  all.reserve(map_.size());
  for (const std::uint32_t place : places_)
    for_voxels_in(place, own(), [&](std::uint32_t number) { all.push_back(number); });
  return all;
}

namespace {

/// The number of a block or a cube, and a lower bound of its distance.
struct NearNumber {
  double gap;
  std::uint32_t number;
  auto operator<=>(const NearNumber&) const = default;
};

/// Calls `look` for all that are no farther than the limit, nearest first; `look` returns the new
/// limit.
template <typename LookAt>
void look_in_order(std::span<NearNumber> near, double limit, const LookAt& look) {
  std::sort(near.begin(), near.end());
  for (const NearNumber& next : near) {
    if (next.gap > limit) return;
    limit = look(next.number);
  }
}

}  // namespace

void VoxelBody::look_at_nearest(const std::optional<Aabb>& own_box, const GapToParts& gap,
                                double limit, const Look& look) const {
  std::vector<std::uint32_t> blocks(places_.size());
  std::iota(blocks.begin(), blocks.end(), 0u);
  if (own_box) {
    blocks.clear();
    blocks_.find_overlapping(*own_box, blocks);
  }
  std::vector<NearNumber> near;
  for (const std::uint32_t block : blocks) {
    const double least = gap.to_own(boxes_[block]);
    if (least <= limit) near.push_back({least, block});
  }
  double now = limit;
  look_in_order(near, limit, [&](std::uint32_t block) {
    if (gap.measured(boxes_[block], now) <= now)
      now = look_in_cube(places_[block], {}, gap, now, look);
    return now;
  });
}

double VoxelBody::look_in_cube(std::uint32_t place, const BlockCube& cube, const GapToParts& gap,
                               double limit, const Look& look) const {
  if (cube.side == 1)
    return look(place * kVoxelsOfBlock + (cube.z * kSideOfBlock + cube.y) * kSideOfBlock + cube.x);
  const std::uint32_t half = cube.side / 2;
  std::vector<NearNumber> near;
  near.reserve(8);
  std::array<Aabb, 8> boxes;
  const auto eighth = [&](std::uint32_t which) {
    return BlockCube{cube.x + (which & 1) * half, cube.y + (which >> 1 & 1) * half,
                     cube.z + (which >> 2) * half, half};
  };
  for (std::uint32_t which = 0; which < 8; ++which) {
    const std::optional<Aabb> box = box_of(map_.blocks_[place], eighth(which));
    if (!box) continue;
    boxes[which] = *box;
    near.push_back({gap.to_own(*box), which});
  }
  double now = limit;
  look_in_order(near, limit, [&](std::uint32_t which) {
    if (half == 1 || gap.measured(boxes[which], now) <= now)
      now = look_in_cube(place, eighth(which), gap, now, look);
    return now;
  });
  return now;
}

void VoxelBody::visit_along(const Ray& own_ray, const Look& look) const {
  Ray shorter = own_ray;
  const auto look_at = [&](std::uint32_t block) {
    const std::uint32_t place = places_[block];
    const Aabb along = box_along(shorter, grown(boxes_[block], index_room()));
    for_voxels_in(place, along, [&](std::uint32_t number) { shorter.max_distance = look(number); });
    return shorter.max_distance;
  };
  blocks_.visit_along(own_ray, std::cref(look_at));  // a reference, so that nothing is allocated
}

void VoxelBody::check_parts(const Pose& pose) const {
  for (const std::uint32_t number : all_parts())
    check_pose(placed_part(pose, map_.pose(number)), "pose of a part");
}

const VoxelMap* voxel_map_of(const BodyShape& shape) {
  if (typeid(shape) != typeid(VoxelBody)) return nullptr;
  return &static_cast<const VoxelBody&>(shape).map();
}

std::shared_ptr<const BodyShape> share(const VoxelMap& map) {
  return bvh::in_standard_arithmetic(
      [&]() -> std::shared_ptr<const BodyShape> { return std::make_shared<VoxelBody>(map); });
}

}  // namespace graze
