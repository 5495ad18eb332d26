#include <graze/engine/record/shapes/settings_content.h>

namespace graze::record {

void write_filter(const Filter& filter, ByteWriter& to) {
  to.number(filter.category), to.number(filter.mask), to.difference(filter.group);
}

Filter read_filter(ByteReader& from) {
  Filter filter;
  filter.category = from.number_up_to(0xffffffff, "category");
  filter.mask = from.number_up_to(0xffffffff, "mask");
  const std::int64_t group = from.difference();
  filter.group = static_cast<std::int32_t>(group);
  if (filter.group != group) from.fail("a filter's group is none");
  return filter;
}

void write_settings(const BodySettings& settings, ByteWriter& to) {
  to.byte(static_cast<std::uint8_t>(static_cast<unsigned>(settings.kind) |
                                    static_cast<unsigned>(settings.role) << 2 |
                                    static_cast<unsigned>(settings.detection) << 3 |
                                    static_cast<unsigned>(settings.sides.kind()) << 4));
  write_filter(settings.filter, to);
  to.number(settings.user_data);
  to.real(settings.margin);
  to.real(settings.sides.thickness());
}

namespace {

MeshSides read_sides(Sides kind, ByteReader& from) {
  const double thickness = from.real();
  if (kind == Sides::OneSided) return MeshSides::one_sided(thickness);
  if (thickness != 0) from.fail("a body that is not one-sided has a thickness");
  return kind == Sides::Solid ? MeshSides::solid() : MeshSides::surface();
}

}  // namespace

BodySettings read_settings(ByteReader& from) {
  const unsigned bits = from.flags(0x3f, "a body's settings");
  if ((bits & 3) == 3 || bits >> 4 == 3) from.fail("a body's settings are none");
  BodySettings settings;
  settings.kind = static_cast<BodyKind>(bits & 3);
  settings.role = static_cast<Role>(bits >> 2 & 1);
  settings.detection = static_cast<Detection>(bits >> 3 & 1);
  settings.filter = read_filter(from);
  settings.user_data = from.number();
  settings.margin = from.real();
  settings.sides = read_sides(static_cast<Sides>(bits >> 4), from);
  return settings;
}

}  // namespace graze::record
