#pragma once

// The parts of a body as a world under test is given them.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>

#include <memory>
#include <variant>
#include <vector>

#include "tests/engine/histories/history.h"
#include "tests/engine/histories/parts_plan.h"

namespace graze::tests {

using Whole = std::variant<Compound, VoxelMap>;

Whole whole_of(const PartsPlan& plan, const std::vector<Shape>& palette);
/// An operation that the whole takes: see PartTable.
void change(Whole& whole, const Operation& operation, const std::vector<Shape>& palette);
std::shared_ptr<const BodyShape> shared(const Whole& whole);

}  // namespace graze::tests
