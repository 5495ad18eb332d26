#include <graze/bvh/error.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/mesh/data/orientation.h>
#include <graze/engine/mesh/health/inside_out.h>
#include <graze/engine/world/contacts/sides/enclosure.h>

#include <cmath>
#include <optional>
#include <string>

namespace graze {

namespace {

void refuse(const Mesh& mesh, const TriangleEdge& edge, const std::string& why) {
  const TriangleIndices& triangle = mesh.triangles()[edge.triangle];
  const auto corner = [&](int k) {
    return std::to_string(triangle[static_cast<std::size_t>(k % 3)]);
  };
  throw MeshError(why + ": the edge from vertex " + corner(edge.k) + " to vertex " +
                      corner(edge.k + 1) + " of triangle " + std::to_string(edge.triangle),
                  {.element = "triangle", .index = edge.triangle});
}

}  // namespace

void check_sides(const Shape* shape, const MeshSides& sides, const char* what) {
  const std::string begin = std::string(what) + ": ";
  if (sides.kind() == Sides::OneSided &&
      !(std::isfinite(sides.thickness()) && sides.thickness() > 0)) {
    throw InputError(begin + "the thickness is " + bvh::number_text(sides.thickness()) +
                     ", but must be finite and above 0");
  }
  if (sides.kind() == Sides::Surface) return;
  if (shape != nullptr && shape->kind() == ShapeKind::HeightField) {
    // All triangles of a height field have their fronts on one side.
    if (sides.kind() == Sides::OneSided) return;
    throw MeshError(begin + "a height field has a border, and a solid has none");
  }
  const Mesh* mesh = shape == nullptr ? nullptr : shape->as<Mesh>();
  if (mesh == nullptr) throw InputError(begin + "only meshes and height fields have sides");
  const Orientation& orientation = orientation_of(*mesh);
  if (sides.kind() == Sides::Solid) {
    if (orientation.unpaired)
      refuse(*mesh, *orientation.unpaired,
             begin + "a solid needs as many triangles one way as the other at each edge");
    // Bodies leave through fronts.
    if (const std::optional<std::uint32_t> triangle = first_inside_out(*mesh)) {
      throw MeshError(begin + "a solid needs triangles whose fronts are outside: the part of the " +
                          "surface with triangle " + std::to_string(*triangle) + " is inside out",
                      {.element = "triangle", .index = *triangle});
    }
  } else if (orientation.turned) {
    refuse(*mesh, *orientation.turned,
           begin + "one side needs triangles that go on from each other at each edge");
  }
}

}  // namespace graze
