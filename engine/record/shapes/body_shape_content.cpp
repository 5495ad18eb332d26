// Writes and reads compounds and maps of voxels, whose parts keep their numbers.

#include <graze/bvh/error.h>
#include <graze/engine/record/coding/pose_track.h>
#include <graze/engine/record/shapes/settings_content.h>
#include <graze/engine/record/shapes/shape_content.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace graze::record {
namespace {

constexpr std::uint32_t kSide = VoxelMap::kBlock;
constexpr std::uint32_t kBlockVoxels = kSide * kSide * kSide;
constexpr std::uint32_t kMostBlocks = std::uint32_t{1} << 20;

void write_compound(const Compound& compound, const NumberOfShape& number_of, ByteWriter& to) {
  const std::vector<std::uint32_t> parts = compound.parts();
  to.number(parts.size());
  std::uint32_t next = 0;
  for (const std::uint32_t number : parts) {
    const PlacedShape& part = compound.part(number);
    const PartSettings& settings = compound.settings(number);
    to.number(number - next);
    next = number + 1;
    to.number(number_of(part.shape));
    write_pose(part.pose, to);
    to.byte(settings.filter ? 1 : 0);
    if (settings.filter) write_filter(*settings.filter, to);
    to.number(settings.user_data), to.number(settings.material);
  }
}

/// Reads a compound. Numbers that no part has are those of parts that were removed again.
Compound read_compound(ByteReader& from, const ShapeOfNumber& shape_of) {
  Compound compound;
  std::vector<std::uint32_t> removed;
  std::uint32_t next = 0;
  for (std::size_t left = from.count(100, "parts"); left > 0; --left) {
    const std::uint32_t skipped = from.number_up_to(0xffffff, "parts that are none");
    const std::uint32_t shape = from.number_up_to(0xffffffff, "shape");
    const Shape* known = shape_of(shape);
    if (known == nullptr) from.fail("a part of a shape that is none");
    const Pose pose = read_pose(from);
    PartSettings settings;
    if (from.flags(1, "filter") != 0) settings.filter = read_filter(from);
    settings.user_data = from.number();
    settings.material = from.number_up_to(0xffffffff, "material");
    for (std::uint32_t i = 0; i < skipped; ++i)
      removed.push_back(compound.add({*known, pose}));
    if (next + skipped != compound.add({*known, pose}, settings)) from.fail("parts are too many");
    next += skipped + 1;
  }
  for (const std::uint32_t number : removed)
    compound.remove(number);
  return compound;
}

/// Writes voxels by the place of their block, which their numbers as parts begin with.
void write_voxel_map(const VoxelMap& map, ByteWriter& to) {
  const VoxelGrid& grid = map.grid();
  for (int i = 0; i < 3; ++i)
    to.real(grid.origin[i]);
  to.real(grid.edge);
  for (const std::uint32_t count : grid.counts)
    to.number(count);
  std::map<std::uint32_t, std::vector<Voxel>> blocks;
  for (const Voxel& voxel : map.voxels())
    blocks[map.part(voxel) / kBlockVoxels].push_back(voxel);
  to.number(blocks.size());
  std::uint32_t next = 0;
  for (const auto& [place, voxels] : blocks) {
    to.number(place - next);
    next = place + 1;
    to.number(voxels.size());
    for (const Voxel& voxel : voxels)
      to.number(voxel.i), to.number(voxel.j), to.number(voxel.k);
  }
}

using BlockCorner = std::array<std::uint32_t, 3>;

BlockCorner corner_of(const Voxel& voxel) {
  return {voxel.i / kSide, voxel.j / kSide, voxel.k / kSide};
}

/// Puts voxels of blocks that have none into the places that are skipped, and takes them out at the
/// end, because blocks take places one after the other.
class PlaceFiller {
 public:
  PlaceFiller(VoxelMap& map, std::set<BlockCorner> taken) : map_(map), taken_(std::move(taken)) {}

  bool fill(std::uint32_t places) {
    for (; places > 0; --places) {
      while (taken_.contains(next_))
        if (!go_on()) return false;
      if (next_[2] * kSide >= map_.grid().counts[2]) return false;
      const Voxel voxel{static_cast<std::uint16_t>(next_[0] * kSide),
                        static_cast<std::uint16_t>(next_[1] * kSide),
                        static_cast<std::uint16_t>(next_[2] * kSide)};
      map_.add({&voxel, 1});
      fillers_.push_back(voxel);
      go_on();
    }
    return true;
  }
  void take_out() { map_.remove(fillers_); }

 private:
  bool go_on() {
    const auto& counts = map_.grid().counts;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (++next_[axis] * kSide < counts[axis] || axis == 2) break;
      next_[axis] = 0;
    }
    return next_[2] * kSide < counts[2];
  }

  VoxelMap& map_;
  std::set<BlockCorner> taken_;
  BlockCorner next_{};
  std::vector<Voxel> fillers_;
};

struct PlacedBlock {
  std::uint32_t skipped = 0;  ///< the number of places skipped before it
  std::vector<Voxel> voxels;
};

std::vector<PlacedBlock> read_blocks(ByteReader& from) {
  std::vector<PlacedBlock> blocks(from.count(5, "blocks of voxels"));
  for (PlacedBlock& block : blocks) {
    block.skipped = from.number_up_to(kMostBlocks, "blocks that are none");
    block.voxels.resize(from.count(3, "voxels"));
    if (block.voxels.empty()) from.fail("a block without voxels");
    for (Voxel& voxel : block.voxels) {
      voxel.i = static_cast<std::uint16_t>(from.number_up_to(0xffff, "voxel"));
      voxel.j = static_cast<std::uint16_t>(from.number_up_to(0xffff, "voxel"));
      voxel.k = static_cast<std::uint16_t>(from.number_up_to(0xffff, "voxel"));
      if (corner_of(voxel) != corner_of(block.voxels.front()))
        from.fail("voxels of one block that are of two");
    }
  }
  return blocks;
}

VoxelMap read_voxel_map(ByteReader& from) {
  VoxelGrid grid;
  for (int i = 0; i < 3; ++i)
    grid.origin[i] = from.real();
  grid.edge = from.real();
  for (std::uint32_t& count : grid.counts)
    count = from.number_up_to(0xffff, "voxels along an axis");
  VoxelMap map(grid);
  const std::vector<PlacedBlock> blocks = read_blocks(from);
  std::set<BlockCorner> taken;
  for (const PlacedBlock& block : blocks) {
    if (!taken.insert(corner_of(block.voxels.front())).second) from.fail("a block stands twice");
  }
  PlaceFiller filler(map, std::move(taken));
  for (const PlacedBlock& block : blocks) {
    if (!filler.fill(block.skipped)) from.fail("more blocks are skipped than the grid has");
    map.add(block.voxels);
  }
  filler.take_out();
  return map;
}

}  // namespace

bool can_be_written(const BodyShape& shape) {
  return shape.shape() != nullptr || compound_of(shape) != nullptr ||
         voxel_map_of(shape) != nullptr;
}

void write_body_shape(const BodyShape& shape, const NumberOfShape& number_of, ByteWriter& to) {
  if (const Shape* known = shape.shape()) {
    write_shape(*known, to);
  } else if (const Compound* compound = compound_of(shape)) {
    to.byte(kCompoundKind);
    write_compound(*compound, number_of, to);
  } else if (const VoxelMap* map = voxel_map_of(shape)) {
    to.byte(kVoxelMapKind);
    write_voxel_map(*map, to);
  } else {
    throw InputError("record: a shape of a user's own cannot be kept");
  }
}

std::shared_ptr<const BodyShape> read_body_shape(ByteReader& from, const ShapeOfNumber& shape_of) {
  const std::uint8_t kind = from.byte();
  if (kind == kCompoundKind) return share(read_compound(from, shape_of));
  if (kind == kVoxelMapKind) return share(read_voxel_map(from));
  return share(read_shape(kind, from));
}

}  // namespace graze::record
