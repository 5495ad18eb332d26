#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/values/height_fields.h>
#include <graze/engine/python/binding/values/shapes.h>

#include <graze/bvh/error.h>
#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/shape_bounds.h>

#include <string>

namespace graze::python {
namespace {

py::object tuple_of(const Eigen::Vector3d& vector) {
  return py::make_tuple(vector.x(), vector.y(), vector.z());
}

ConvexHull hull_from(py::handle argument) {
  const Points points(argument, "points");
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    corners.push_back(points[i]);
  const py::gil_scoped_release released;
  return ConvexHull(corners);
}

/// Makes a shape of a kind that goes by its word, from what its class in Python was called with.
Shape make_shape(const std::string& kind, const py::args& numbers) {
  const auto number = [&](std::size_t i, const char* name) {
    return number_from(numbers[i], name);
  };
  const auto vector = [&](std::size_t i, const char* name) {
    return vector_from(numbers[i], name);
  };
  if (kind == "sphere") return Sphere{vector(0, "centre"), number(1, "radius")};
  if (kind == "box") return Box{vector(0, "half_extents")};
  if (kind == "capsule") return Capsule{number(0, "radius"), number(1, "half_length")};
  if (kind == "cylinder") return Cylinder{number(0, "radius"), number(1, "half_height")};
  if (kind == "cone") return Cone{number(0, "radius"), number(1, "half_height")};
  if (kind == "ellipsoid") return Ellipsoid{vector(0, "centre"), vector(1, "semi_axes")};
  if (kind == "plane") return Plane{vector(0, "normal"), number(1, "offset")};
  if (kind == "half-space") return HalfSpace{vector(0, "normal"), number(1, "offset")};
  if (kind == "convex hull") return hull_from(numbers[0]);
  if (kind == "height field") return field_from(numbers);
  throw InputError("kind: \"" + kind + "\" is no kind of shape");
}

py::object hull_vertices(const ConvexHull& hull) {
  auto vertices = new_array<double>({static_cast<py::ssize_t>(hull.vertex_count()), 3});
  for (std::size_t i = 0; i < hull.vertex_count(); ++i)
    write(hull.vertex(i), vertices.mutable_data() + 3 * i);
  return vertices;
}

/// Returns what make_shape() takes to make an equal shape.
struct Arguments {
  py::tuple operator()(const Sphere& sphere) const {
    return py::make_tuple(tuple_of(sphere.centre), sphere.radius);
  }
  py::tuple operator()(const Box& box) const { return py::make_tuple(tuple_of(box.half_extents)); }
  py::tuple operator()(const Capsule& capsule) const {
    return py::make_tuple(capsule.radius, capsule.half_length);
  }
  py::tuple operator()(const Cylinder& cylinder) const {
    return py::make_tuple(cylinder.radius, cylinder.half_height);
  }
  py::tuple operator()(const Cone& cone) const {
    return py::make_tuple(cone.radius, cone.half_height);
  }
  py::tuple operator()(const Ellipsoid& ellipsoid) const {
    return py::make_tuple(tuple_of(ellipsoid.centre), tuple_of(ellipsoid.semi_axes));
  }
  py::tuple operator()(const ConvexHull& hull) const { return py::make_tuple(hull_vertices(hull)); }
  py::tuple operator()(const Plane& plane) const {
    return py::make_tuple(tuple_of(plane.normal), plane.offset);
  }
  py::tuple operator()(const HalfSpace& half_space) const {
    return py::make_tuple(tuple_of(half_space.normal), half_space.offset);
  }
  py::tuple operator()(const Mesh& mesh) const { return py::make_tuple(mesh); }
  py::tuple operator()(const HeightField& field) const { return arguments_of(field); }
};

/// Returns the corners of each facet of a hull.
py::list facets_of(const Shape& shape) {
  const ConvexHull* hull = shape.as<ConvexHull>();
  if (hull == nullptr) throw py::type_error("this is no hull");
  py::list facets;
  for (std::size_t i = 0; i < hull->facet_count(); ++i) {
    const auto corners = hull->facet(i);
    facets.append(array_over<std::uint32_t>(std::vector(corners.begin(), corners.end())));
  }
  return facets;
}

py::object bounds_of_shape(py::handle argument) {
  const Placed placed(argument, "shape");
  if (placed.poses().is_many()) throw InputError("shape: many poses are not taken");
  const Aabb box = bounding_aabb(placed.shape_at(0));
  auto bounds = new_array<double>({2, 3});
  write(box.min, bounds.mutable_data());
  write(box.max, bounds.mutable_data() + 3);
  return bounds;
}

}  // namespace

py::object object_of(const Shape& shape) {
  if (const Mesh* mesh = shape.as<Mesh>()) return py::cast(*mesh);
  const py::tuple arguments = std::visit(Arguments{}, shape.value());
  return py::module_::import("graze._shapes").attr("of_kind")(name_of(shape.kind()), *arguments);
}

void add_shapes(py::module_& module) {
  py::class_<Shape>(
      module, "Shape",
      R"(A convex solid, a half-space or a terrain, in its own frame, metres; see Sphere, Box and the other classes.

Shapes do not change; they can be pickled, and stand wherever a Mesh may, alone or as (shape, pose).
)")
      .def(py::init(&make_shape),
           "__init__(self, kind, *numbers)\n--\n\nFor the classes of shapes alone.")
      .def_property_readonly(
          "kind", [](const Shape& shape) { return name_of(shape.kind()); },
          "\"sphere\", \"box\", ... as error messages call it.")
      .def(
          "_arguments", [](const Shape& shape) { return std::visit(Arguments{}, shape.value()); },
          "_arguments(self)\n--\n\nWhat its class was called with.");
  module.def("_facets_of_hull", &facets_of, "_facets_of_hull(hull)\n--\n\nSee ConvexHull.facets.",
             py::arg("hull"));
  module.def("bounding_aabb", &bounds_of_shape, R"(bounding_aabb(shape)
--

A box around a placed shape or mesh, metres, rounded outward: its least and its greatest corner, of the shape (2, 3).

>>> graze.bounding_aabb(graze.Sphere([1, 0, 0], 2))
array([[-1., -2., -2.],
       [ 3.,  2.,  2.]])
)",
             py::arg("shape"));
}

}  // namespace graze::python
