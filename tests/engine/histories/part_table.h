#pragma once

// The parts of a body as the oracle keeps them: one by one, in no tree.

#include <graze/bvh/pose.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/shape.h>
#include <graze/engine/world/voxel_map.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "tests/engine/histories/history.h"
#include "tests/engine/histories/parts_plan.h"

namespace graze::tests {

/// A part in the world, or a body that has none and counts as its own part 0.
struct Piece {
  std::uint32_t number = 0;
  std::uint32_t shape = 0;  // in the palette
  Pose pose = Pose::Identity();
  std::optional<Filter> filter = {};
};

/// Whether nothing tells one from the other: of equal poses each zero has the same sign.
bool are_alike(const Piece& s, const Piece& t);

class PartTable {
 public:
  explicit PartTable(const PartsPlan& plan);

  /// False where an operation on a part is passed over: on voxels of a compound or the other way
  /// round, where nothing would be left, where it would become too many, and for shapes that are no
  /// parts.
  bool takes(const Operation& operation, const std::vector<Shape>& palette) const;
  void change(const Operation& operation);

  /// In the order of their numbers.
  std::vector<Piece> pieces(const Pose& body) const;
  /// All of them as one shape, to be asked without a world.
  std::shared_ptr<const BodyShape> together(const std::vector<Shape>& palette) const;
  /// Throws std::runtime_error unless a world's shape has these parts and no others.
  void check(const BodyShape& shape) const;

 private:
  bool takes_voxels(const Operation& operation) const;
  std::uint32_t number_of(std::uint32_t place) const;
  std::uint32_t new_number();

  std::map<std::uint32_t, PartsPlan::Part> parts_;  // by number
  std::vector<std::uint32_t> free_;                 // numbers, the last is given out first
  std::uint32_t next_ = 0;
  std::optional<VoxelGrid> grid_;
  std::set<Voxel> voxels_;
  std::uint32_t voxel_shape_ = 0;
  std::optional<VoxelMap> numbers_;  // what a map of these voxels calls them
};

}  // namespace graze::tests
