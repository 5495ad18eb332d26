#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/shape_bounds.h>

#include <string>
#include <utility>

namespace graze {
namespace {

/// Throws unless the shape can be a part.
void check_part(const PlacedShapeView& part) {
  if (part.shape.kind() == ShapeKind::HalfSpace || part.shape.kind() == ShapeKind::Plane)
    throw InputError(std::string("part: a ") + name_of(part.shape.kind()) +
                     " is a body of its own, and no part of a compound");
  bounding_aabb(part);
}

}  // namespace

const Compound::Part& Compound::at(std::uint32_t part, const char* what) const {
  if (!contains(part)) {
    throw StaleIdError(std::string(what) + ": the compound has no part " + std::to_string(part),
                       {.element = "part", .index = part});
  }
  return *parts_[part];
}

std::uint32_t Compound::add(const PlacedShapeView& part, const PartSettings& settings) {
  check_part(part);
  Part added{{part.shape, part.pose}, settings};
  std::uint32_t number;
  if (free_.empty()) {
    number = static_cast<std::uint32_t>(parts_.size());
    parts_.emplace_back(std::move(added));
  } else {
    number = free_.back();
    free_.pop_back();
    parts_[number] = std::move(added);
  }
  return number;
}

void Compound::replace(std::uint32_t part, const PlacedShapeView& by) {
  at(part, "replace");
  check_part(by);
  parts_[part]->placed = {by.shape, by.pose};
}

void Compound::set_settings(std::uint32_t part, const PartSettings& settings) {
  at(part, "set_settings");
  parts_[part]->settings = settings;
}

void Compound::remove(std::uint32_t part) {
  at(part, "remove");
  free_.push_back(part);
  parts_[part].reset();
}

bool Compound::contains(std::uint32_t part) const {
  return part < parts_.size() && parts_[part].has_value();
}

std::vector<std::uint32_t> Compound::parts() const {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t number = 0; number < parts_.size(); ++number) {
    if (parts_[number]) numbers.push_back(number);
  }
  return numbers;
}

const PlacedShape& Compound::part(std::uint32_t part) const {
  return at(part, "part").placed;
}

const PartSettings& Compound::settings(std::uint32_t part) const {
  return at(part, "settings").settings;
}

Pose placed_part(const Pose& body, const Pose& part) {
  return bvh::in_standard_arithmetic([&]() -> Pose {
    Pose placed = Pose::Identity();
    const double* m = body.data();  // column-major 4x4
    for (int column = 0; column < 4; ++column) {
      const double* p = part.data() + 4 * column;
      for (int i = 0; i < 3; ++i) {
        const double turned = (m[i] * p[0] + m[4 + i] * p[1]) + m[8 + i] * p[2];
        placed.data()[4 * column + i] = column < 3 ? turned : turned + m[12 + i];
      }
    }
    return placed;
  });
}

}  // namespace graze
