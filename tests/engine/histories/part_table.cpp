#include "tests/engine/histories/part_table.h"

#include <graze/engine/world/compound.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <iterator>
#include <string>

#include "tests/engine/histories/questions.h"

namespace graze::tests {
namespace {

/// All from the first to the last.
std::vector<Voxel> voxels_of(const Operation& operation) {
  const auto& at = operation.voxels;
  std::vector<Voxel> all;
  for (std::uint32_t k = at[2]; k <= at[5]; ++k)
    for (std::uint32_t j = at[1]; j <= at[4]; ++j)
      for (std::uint32_t i = at[0]; i <= at[3]; ++i)
        all.push_back({static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                       static_cast<std::uint16_t>(k)});
  return all;
}

bool is_no_part(const Shape& shape) {
  return shape.kind() == ShapeKind::HalfSpace || shape.kind() == ShapeKind::Plane;
}

/// Its middle, as VoxelMap::pose() defines it.
Pose pose_of_voxel(const VoxelGrid& grid, const Voxel& voxel) {
  Pose pose = Pose::Identity();
  const std::uint16_t at[3] = {voxel.i, voxel.j, voxel.k};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = grid.origin[axis] + at[axis] * grid.edge;
    pose.matrix()(axis, 3) = low + grid.edge / 2;
  }
  return pose;
}

}  // namespace

std::optional<Filter> part_filter(const Operation& operation) {
  if (!operation.has_filter) return std::nullopt;
  return operation.settings.filter;
}

bool is_about_a_part(Verb verb) {
  return verb >= Verb::AddPart && verb <= Verb::ClearVoxels;
}

bool are_alike(const Piece& s, const Piece& t) {
  const auto bits = [](const Pose& pose) {
    std::array<std::uint64_t, 16> all;
    std::transform(pose.data(), pose.data() + 16, all.begin(),
                   [](double entry) { return std::bit_cast<std::uint64_t>(entry); });
    return all;
  };
  return s.shape == t.shape && bits(s.pose) == bits(t.pose);
}

PartTable::PartTable(const PartsPlan& plan)
    : grid_(plan.grid),
      voxels_(plan.voxels.begin(), plan.voxels.end()),
      voxel_shape_(plan.voxel_shape) {
  for (const PartsPlan::Part& part : plan.parts)
    parts_[next_++] = part;
  if (!grid_) return;
  numbers_.emplace(*grid_);
  numbers_->add(plan.voxels);
}

bool PartTable::takes(const Operation& operation, const std::vector<Shape>& palette) const {
  const bool is_of_voxels =
      operation.verb == Verb::FillVoxels || operation.verb == Verb::ClearVoxels;
  if (is_of_voxels != grid_.has_value()) return false;
  if (is_of_voxels) return takes_voxels(operation);
  const bool has_shape = operation.verb == Verb::AddPart || operation.verb == Verb::ReplacePart;
  if (has_shape && (operation.number >= palette.size() || is_no_part(palette[operation.number])))
    return false;
  if (operation.verb == Verb::AddPart) return parts_.size() < kMostParts;
  return operation.verb != Verb::RemovePart || parts_.size() > 1;
}

bool PartTable::takes_voxels(const Operation& operation) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t first = operation.voxels[axis], last = operation.voxels[axis + 3];
    if (first > last || last >= grid_->counts[axis] || last - first > 4) return false;
  }
  std::set<Voxel> after = voxels_;
  for (const Voxel& voxel : voxels_of(operation)) {
    if (operation.verb == Verb::FillVoxels) {
      after.insert(voxel);
    } else {
      after.erase(voxel);
    }
  }
  return !after.empty() && after.size() <= kMostVoxels;
}

/// That of the part that stands at a place among those that there are.
std::uint32_t PartTable::number_of(std::uint32_t place) const {
  return std::next(parts_.begin(), static_cast<std::ptrdiff_t>(place % parts_.size()))->first;
}

std::uint32_t PartTable::new_number() {
  if (free_.empty()) return next_++;
  const std::uint32_t number = free_.back();
  free_.pop_back();
  return number;
}

void PartTable::change(const Operation& operation) {
  switch (operation.verb) {
    case Verb::AddPart:
      parts_[new_number()] = {operation.number, operation.pose, part_filter(operation),
                              operation.number};
      return;
    case Verb::ReplacePart: {
      PartsPlan::Part& part = parts_.at(number_of(operation.part));
      part.shape = operation.number;
      part.pose = operation.pose;
      return;
    }
    case Verb::MovePart:
      parts_.at(number_of(operation.part)).pose = operation.pose;
      return;
    case Verb::RemovePart: {
      const std::uint32_t number = number_of(operation.part);
      parts_.erase(number);
      free_.push_back(number);
      return;
    }
    case Verb::SetPart: {
      PartsPlan::Part& part = parts_.at(number_of(operation.part));
      part.filter = part_filter(operation);
      part.label = operation.number;
      return;
    }
    default:
      break;
  }
  const std::vector<Voxel> changed = voxels_of(operation);
  if (operation.verb == Verb::FillVoxels) {
    voxels_.insert(changed.begin(), changed.end());
    numbers_->add(changed);
  } else {
    for (const Voxel& voxel : changed)
      voxels_.erase(voxel);
    numbers_->remove(changed);
  }
}

std::vector<Piece> PartTable::pieces(const Pose& body) const {
  std::vector<Piece> pieces;
  for (const auto& [number, part] : parts_)
    pieces.push_back({number, part.shape, placed_part(body, part.pose), part.filter});
  for (const Voxel& voxel : voxels_) {
    pieces.push_back({numbers_->part(voxel), voxel_shape_,
                      placed_part(body, pose_of_voxel(*grid_, voxel)), std::nullopt});
  }
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& s, const Piece& t) { return s.number < t.number; });
  return pieces;
}

std::shared_ptr<const BodyShape> PartTable::together(const std::vector<Shape>& palette) const {
  if (numbers_) return share(*numbers_);
  Compound compound;
  for (const auto& [number, part] : parts_)
    compound.add({palette[part.shape], part.pose});
  return share(compound);
}

void PartTable::check(const BodyShape& shape) const {
  if (const VoxelMap* map = voxel_map_of(shape)) {
    expect(grid_.has_value(), "a compound has become a map of voxels");
    expect(map->voxels() == std::vector<Voxel>(voxels_.begin(), voxels_.end()),
           "a map has other voxels");
    for (const Voxel& voxel : voxels_) {
      const std::uint32_t number = numbers_->part(voxel);
      expect(map->voxel(number) == voxel &&
                 map->pose(number).matrix() == pose_of_voxel(*grid_, voxel).matrix(),
             "voxel " + std::to_string(number) + " is not where it was");
    }
    return;
  }
  const Compound* compound = compound_of(shape);
  expect(compound != nullptr && !grid_, "a body has lost its parts");
  std::vector<std::uint32_t> numbers;
  for (const auto& [number, part] : parts_) {
    numbers.push_back(number);
    const PartSettings& settings = compound->settings(number);
    expect(compound->part(number).pose.matrix() == part.pose.matrix() &&
               settings.filter == part.filter && settings.user_data == part.label &&
               settings.material == part.label,
           "part " + std::to_string(number) + " is not as it was told to be");
  }
  expect(compound->parts() == numbers, "a compound has other parts");
}

}  // namespace graze::tests
