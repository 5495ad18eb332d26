#include "tests/engine/histories/whole.h"

#include <stdexcept>

namespace graze::tests {
namespace {

void change_part(Compound& compound, const Operation& operation,
                 const std::vector<Shape>& palette) {
  const PartSettings settings{.filter = part_filter(operation),
                              .user_data = operation.number,
                              .material = operation.number};
  if (operation.verb == Verb::AddPart) {
    compound.add({palette[operation.number], operation.pose}, settings);
    return;
  }
  const std::vector<std::uint32_t> numbers = compound.parts();
  const std::uint32_t part = numbers[operation.part % numbers.size()];
  switch (operation.verb) {
    case Verb::ReplacePart:
      return compound.replace(part, {palette[operation.number], operation.pose});
    case Verb::MovePart: {
      const Shape shape = compound.part(part).shape;
      return compound.replace(part, {shape, operation.pose});
    }
    case Verb::RemovePart:
      return compound.remove(part);
    case Verb::SetPart:
      return compound.set_settings(part, settings);
    default:
      throw std::logic_error("not an operation on a part");
  }
}

void change_voxels(VoxelMap& map, const Operation& operation) {
  const auto& at = operation.voxels;
  const Voxel first{at[0], at[1], at[2]}, last{at[3], at[4], at[5]};
  const bool is_fill = operation.verb == Verb::FillVoxels;
  if (first == last) {
    const std::vector<Voxel> one{first};
    return is_fill ? map.add(one) : map.remove(one);
  }
  return is_fill ? map.add_block(first, last) : map.remove_block(first, last);
}

}  // namespace

Whole whole_of(const PartsPlan& plan, const std::vector<Shape>& palette) {
  if (plan.grid) {
    VoxelMap map(*plan.grid);
    map.add(plan.voxels);
    return map;
  }
  Compound compound;
  for (const PartsPlan::Part& part : plan.parts) {
    compound.add({palette[part.shape], part.pose},
                 {.filter = part.filter, .user_data = part.label, .material = part.label});
  }
  return compound;
}

void change(Whole& whole, const Operation& operation, const std::vector<Shape>& palette) {
  if (auto* map = std::get_if<VoxelMap>(&whole)) return change_voxels(*map, operation);
  change_part(std::get<Compound>(whole), operation, palette);
}

std::shared_ptr<const BodyShape> shared(const Whole& whole) {
  return std::visit([](const auto& parts) { return share(parts); }, whole);
}

}  // namespace graze::tests
