#include <graze/engine/files/source.h>
#include <graze/engine/scenes/read/scene_units.h>

#include <array>
#include <cmath>
#include <string>

namespace graze::scenes {
namespace {

constexpr std::array<LengthUnit, 6> kLengths = {{{"m", 1, 1},
                                                 {"cm", 1, 100},
                                                 {"mm", 1, 1000},
                                                 {"um", 1, 1e6},
                                                 {"km", 1000, 1},
                                                 {"in", 0.0254, 1}}};
constexpr std::array<AngleUnit, 3> kAngles = {
    {{"degree", 360}, {"radian", 6.283185307179586}, {"turn", 1}}};

template <typename Units>
auto read_unit(const cases::JsonCursor& at, const Units& units) {
  std::string list;
  for (const auto& unit : units) {
    if (at.text() == unit.name) return unit;
    list += (list.empty() ? "" : ", ") + std::string(unit.name);
  }
  at.fail("there is no unit " + mesh_io::quoted(at.text()) + "; there are " + list);
}

}  // namespace

LengthUnit read_length_unit(const cases::JsonCursor& at) {
  return read_unit(at, kLengths);
}

AngleUnit read_angle_unit(const cases::JsonCursor& at) {
  return read_unit(at, kAngles);
}

double SceneUnits::read_length(const cases::JsonCursor& at) const {
  const double metres = length.to_metres(at.number());
  if (!std::isfinite(metres)) at.fail("is beyond the range of double in metres");
  return metres;
}

Eigen::Vector3d SceneUnits::read_point(const cases::JsonCursor& at) const {
  at.require_size(3);
  Eigen::Vector3d point;
  for (std::size_t i = 0; i < 3; ++i)
    point.data()[i] = read_length(at.item(i));
  return point;
}

}  // namespace graze::scenes
