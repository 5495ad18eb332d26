#include <graze/engine/values/text.h>
#include <graze/print.h>

#include <ostream>
#include <variant>

namespace graze {

std::ostream& operator<<(std::ostream& out, const Ellipsoid& ellipsoid) {
  return out << Text("ellipsoid around ", ellipsoid.centre, " of semi-axes ", ellipsoid.semi_axes);
}
std::ostream& operator<<(std::ostream& out, const Box& box) {
  return out << Text("box of half extents ", box.half_extents);
}
std::ostream& operator<<(std::ostream& out, const Capsule& capsule) {
  return out << Text("capsule of radius ", capsule.radius, " and half length ",
                     capsule.half_length);
}
std::ostream& operator<<(std::ostream& out, const Cylinder& cylinder) {
  return out << Text("cylinder of radius ", cylinder.radius, " and half height ",
                     cylinder.half_height);
}
std::ostream& operator<<(std::ostream& out, const Cone& cone) {
  return out << Text("cone of radius ", cone.radius, " and half height ", cone.half_height);
}
std::ostream& operator<<(std::ostream& out, const HalfSpace& half_space) {
  return out << Text("half-space below ", half_space.offset, " along ", half_space.normal);
}
std::ostream& operator<<(std::ostream& out, const Plane& plane) {
  return out << Text("plane at ", plane.offset, " along ", plane.normal);
}
std::ostream& operator<<(std::ostream& out, const ConvexHull& hull) {
  return out << Text("hull of ", std::uint64_t{hull.vertex_count()}, " vertices");
}
std::ostream& operator<<(std::ostream& out, const HeightField& field) {
  return out << Text("height field of ", field.columns(), " x ", field.rows(), " heights");
}
std::ostream& operator<<(std::ostream& out, const FieldRange& range) {
  return out << Text(range.columns, " x ", range.rows, " heights from column ", range.first_column,
                     ", row ", range.first_row);
}
std::ostream& operator<<(std::ostream& out, const Mesh& mesh) {
  return out << Text("mesh of ", std::uint64_t{mesh.vertices().size()}, " vertices and ",
                     std::uint64_t{mesh.triangles().size()}, " triangles");
}
std::ostream& operator<<(std::ostream& out, const Shape& shape) {
  std::visit([&](const auto& value) { out << value; }, shape.value());
  return out;
}
std::ostream& operator<<(std::ostream& out, const PlacedShape& placed) {
  return out << placed.shape << Text(" in pose ", to_text(placed.pose));
}
std::ostream& operator<<(std::ostream& out, const PlacedMesh& placed) {
  return out << placed.mesh << Text(" in pose ", to_text(placed.pose));
}
std::ostream& operator<<(std::ostream& out, const ShapeInMotion& moving) {
  return out << moving.shape << Text(" ") << moving.motion;
}
std::ostream& operator<<(std::ostream& out, const MeshInMotion& moving) {
  return out << moving.mesh << Text(" ") << moving.motion;
}
std::ostream& operator<<(std::ostream& out, const RigidPair& pair) {
  return out << pair.a << Text(" and ") << pair.b;
}
std::ostream& operator<<(std::ostream& out, const MeshSides& sides) {
  out << sides.kind();
  return sides.kind() == Sides::OneSided ? out << Text(", ", sides.thickness(), " thick") : out;
}
std::ostream& operator<<(std::ostream& out, const Filter& filter) {
  out << Text("categories ", filter.category, ", mask ", filter.mask);
  return filter.group == 0 ? out : out << Text(", group ", std::to_string(filter.group));
}
std::ostream& operator<<(std::ostream& out, const BoxGap& gap) {
  if (!(gap.gap > 0)) return out << Text("no gap");
  return out << Text("gap ", gap.gap, " in ",
                     std::string_view("xyz").substr(static_cast<std::size_t>(gap.axis), 1),
                     gap.is_a_below ? ", A below" : ", B below");
}

}  // namespace graze
