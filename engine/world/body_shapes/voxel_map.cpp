#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/shape.h>
#include <graze/engine/world/voxel_map.h>

#include <algorithm>
#include <bit>
#include <string>

namespace graze {
namespace {

constexpr std::uint32_t kBlockSide = VoxelMap::kBlock;
constexpr std::uint32_t kBlockVoxels = kBlockSide * kBlockSide * kBlockSide;
constexpr std::size_t kMostBlocks = std::size_t{1} << 20;

std::uint32_t row_of(const Voxel& voxel) {
  return voxel.k % kBlockSide * kBlockSide + voxel.j % kBlockSide;
}

std::string name_of(const Voxel& voxel) {
  return "(" + std::to_string(voxel.i) + ", " + std::to_string(voxel.j) + ", " +
         std::to_string(voxel.k) + ")";
}

/// Returns the bits of a row from `first` to `last`.
std::uint16_t bits_of(std::uint32_t first, std::uint32_t last) {
  return static_cast<std::uint16_t>((0xffffu >> (kBlockSide - 1 - (last - first))) << first);
}

Voxel voxel_at(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  return {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
          static_cast<std::uint16_t>(k)};
}

}  // namespace

VoxelMap::VoxelMap(const VoxelGrid& grid) : grid_(grid) {
  grid.check();
}

VoxelMap::VoxelMap(const Voxels& voxels) : VoxelMap(voxels.grid) {
  add(voxels.voxels);
}

std::uint64_t VoxelMap::key_of(const Voxel& voxel) {
  return std::uint64_t{voxel.k / kBlockSide} << 32 | std::uint64_t{voxel.j / kBlockSide} << 16 |
         voxel.i / kBlockSide;
}

void VoxelMap::check(const Voxel& voxel, const char* what) const {
  const auto& [x, y, z] = grid_.counts;
  if (voxel.i < x && voxel.j < y && voxel.k < z) return;
  throw InputError(std::string(what) + ": voxel " + name_of(voxel) + " is not of the grid of " +
                       std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z),
                   {.element = "voxel"});
}

const VoxelMap::Block* VoxelMap::find(const Voxel& voxel) const {
  const auto found = places_.find(key_of(voxel));
  return found == places_.end() ? nullptr : &blocks_[found->second];
}

VoxelMap::Block& VoxelMap::make(const Voxel& voxel) {
  const std::uint64_t key = key_of(voxel);
  const auto found = places_.find(key);
  if (found != places_.end()) return blocks_[found->second];
  if (free_.empty()) {
    if (blocks_.size() == kMostBlocks)
      throw InputError("add: voxel " + name_of(voxel) + " needs more than 2^20 blocks of voxels",
                       {.element = "voxel"});
    blocks_.emplace_back();
    free_.push_back(static_cast<std::uint32_t>(blocks_.size() - 1));
  }
  const std::uint32_t place = free_.back();
  places_.emplace(key, place);
  free_.pop_back();
  blocks_[place].key = key;
  return blocks_[place];
}

void VoxelMap::set_row(Block& block, std::uint32_t row, std::uint16_t bits, bool is_full) {
  std::uint16_t& now = block.rows[row];
  const std::uint16_t changed = static_cast<std::uint16_t>(bits & (is_full ? ~now : now));
  const auto count = static_cast<std::uint32_t>(std::popcount(changed));
  now = static_cast<std::uint16_t>(now ^ changed);
  block.count = is_full ? block.count + count : block.count - count;
  size_ = is_full ? size_ + count : size_ - count;
}

void VoxelMap::set_block(const Voxel& first, const Voxel& last, bool is_full, const char* what) {
  check(first, what);
  check(last, what);
  if (last.i < first.i || last.j < first.j || last.k < first.k) {
    throw InputError(std::string(what) + ": " + name_of(last) + " is before " + name_of(first),
                     {.element = "voxel"});
  }
  for (std::uint32_t k = first.k / kBlockSide; k <= last.k / kBlockSide; ++k) {
    for (std::uint32_t j = first.j / kBlockSide; j <= last.j / kBlockSide; ++j) {
      for (std::uint32_t i = first.i / kBlockSide; i <= last.i / kBlockSide; ++i) {
        const Voxel corner = voxel_at(i * kBlockSide, j * kBlockSide, k * kBlockSide);
        if (!is_full && find(corner) == nullptr) continue;
        Block& block = make(corner);
        const auto low = [](std::uint32_t from, std::uint32_t at) {
          return std::max(from, at * kBlockSide) - at * kBlockSide;
        };
        const auto high = [](std::uint32_t to, std::uint32_t at) {
          return std::min(to, at * kBlockSide + kBlockSide - 1) - at * kBlockSide;
        };
        const std::uint16_t bits = bits_of(low(first.i, i), high(last.i, i));
        for (std::uint32_t z = low(first.k, k); z <= high(last.k, k); ++z) {
          for (std::uint32_t y = low(first.j, j); y <= high(last.j, j); ++y)
            set_row(block, z * kBlockSide + y, bits, is_full);
        }
        if (block.count != 0) continue;
        free_.push_back(places_.at(block.key));
        places_.erase(block.key);
      }
    }
  }
}

void VoxelMap::add(std::span<const Voxel> voxels) {
  for (const Voxel& voxel : voxels)
    check(voxel, "add");
  for (const Voxel& voxel : voxels)
    set_block(voxel, voxel, true, "add");
}

void VoxelMap::remove(std::span<const Voxel> voxels) {
  for (const Voxel& voxel : voxels)
    check(voxel, "remove");
  for (const Voxel& voxel : voxels)
    set_block(voxel, voxel, false, "remove");
}

void VoxelMap::add_block(const Voxel& first, const Voxel& last) {
  set_block(first, last, true, "add_block");
}

void VoxelMap::remove_block(const Voxel& first, const Voxel& last) {
  set_block(first, last, false, "remove_block");
}

bool VoxelMap::contains(const Voxel& voxel) const {
  const Block* block = find(voxel);
  return block != nullptr && (block->rows[row_of(voxel)] >> voxel.i % kBlockSide & 1) != 0;
}

std::vector<Voxel> VoxelMap::voxels() const {
  std::vector<Voxel> all;
  all.reserve(size_);
  for (std::uint32_t place = 0; place < blocks_.size(); ++place) {
    for (std::uint32_t at = 0; blocks_[place].count != 0 && at < kBlockVoxels; ++at) {
      if ((blocks_[place].rows[at / kBlockSide] >> at % kBlockSide & 1) != 0)
        all.push_back(voxel(place * kBlockVoxels + at));
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::uint32_t VoxelMap::part(const Voxel& voxel) const {
  if (!contains(voxel))
    throw StaleIdError("part: voxel " + name_of(voxel) + " is not full", {.element = "voxel"});
  return places_.at(key_of(voxel)) * kBlockVoxels + row_of(voxel) * kBlockSide +
         voxel.i % kBlockSide;
}

Voxel VoxelMap::voxel(std::uint32_t part) const {
  const std::uint32_t place = part / kBlockVoxels, at = part % kBlockVoxels;
  if (place >= blocks_.size() ||
      (blocks_[place].rows[at / kBlockSide] >> at % kBlockSide & 1) == 0) {
    throw StaleIdError("voxel: the map has no part " + std::to_string(part),
                       {.element = "part", .index = part});
  }
  const std::uint64_t key = blocks_[place].key;
  const auto block = [&](int shift) { return static_cast<std::uint32_t>(key >> shift & 0xffff); };
  return voxel_at(block(0) * kBlockSide + at % kBlockSide,
                  block(16) * kBlockSide + at / kBlockSide % kBlockSide,
                  block(32) * kBlockSide + at / (kBlockSide * kBlockSide));
}

Pose VoxelMap::pose(std::uint32_t part) const {
  return bvh::in_standard_arithmetic([&]() -> Pose {
    const Voxel at = voxel(part);
    Pose pose = Pose::Identity();
    pose.translation() =
        Eigen::Vector3d(grid_.plane(0, at.i), grid_.plane(1, at.j), grid_.plane(2, at.k)) +
        Eigen::Vector3d::Constant(grid_.edge / 2);
    return pose;
  });
}

Shape VoxelMap::box() const {
  return Box{Eigen::Vector3d::Constant(grid_.edge / 2)};
}

}  // namespace graze
