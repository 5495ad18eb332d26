#include <graze/engine/python/binding/arguments/arrays.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/module.h>

#include <graze/bvh/fit/kdop_fit.h>
#include <graze/bvh/fit/obb_fit.h>
#include <graze/bvh/fit/sphere_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/fit.h>

#include <optional>
#include <span>

namespace graze::python {
namespace {

/// Returns what `of_mesh(mesh)` or `of_points(points)` returns, as the argument is the one or the
/// other.
template <typename OfMesh, typename OfPoints>
auto fit(py::handle argument, const OfMesh& of_mesh, const OfPoints& of_points) {
  if (py::isinstance<Mesh>(argument)) {
    const Mesh mesh = argument.cast<const Mesh&>();
    const py::gil_scoped_release released;
    return of_mesh(mesh);
  }
  const auto rows = py::module_::import("graze._arrays")
                        .attr("rows_of_doubles")(argument, "mesh")
                        .cast<py::array>();
  const py::gil_scoped_release released;
  const std::span<const Eigen::Vector3d> points(
      reinterpret_cast<const Eigen::Vector3d*>(rows.data()),
      static_cast<std::size_t>(rows.shape(0)));
  return bvh::in_standard_arithmetic([&] { return of_points(points); });
}

py::object sphere_around(py::handle argument) {
  const Sphere sphere = fit(
      argument, [](const Mesh& mesh) { return bounding_sphere(mesh); },
      [](std::span<const Eigen::Vector3d> points) { return bounding_sphere(points); });
  return py::make_tuple(array_of(sphere.centre), sphere.radius);
}

py::object box_around(py::handle argument) {
  const Obb box = fit(
      argument, [](const Mesh& mesh) { return bounding_obb(mesh); },
      [](std::span<const Eigen::Vector3d> points) { return bounding_obb(points); });
  return py::make_tuple(array_of_matrix(box.pose.matrix().data()), array_of(box.half_extents));
}

py::object kdop_around(py::handle argument) {
  static const ResultType kType("KDop");
  const KDop<18> kdop = fit(
      argument, [](const Mesh& mesh) { return bounding_kdop(mesh); },
      [](std::span<const Eigen::Vector3d> points) { return bounding_kdop(points); });
  auto directions = new_array<std::int64_t>({KDop<18>::kSlabs, 3});
  std::int64_t* direction = directions.mutable_data();
  for (const auto& row : kKDopDirections<18>) {
    for (const int number : row)
      *direction++ = number;
  }
  return kType(array_over<double>(std::vector(kdop.min.begin(), kdop.min.end())),
               array_over<double>(std::vector(kdop.max.begin(), kdop.max.end())),
               std::move(directions));
}

double or_nan(const std::optional<double>& number) {
  return number.value_or(std::numeric_limits<double>::quiet_NaN());
}

py::object measured(const Mesh& mesh) {
  static const ResultType kType("MeshFit");
  MeshFit found;
  {
    const py::gil_scoped_release released;
    found = measure_fit(mesh);
  }
  std::vector<double> volumes, surfaces, empty, relative;
  py::list kinds;
  for (const VolumeFit& fit : found.volumes) {
    kinds.append(name_of(fit.type));
    volumes.push_back(fit.volume);
    surfaces.push_back(fit.surface);
    empty.push_back(or_nan(fit.empty_share));
    relative.push_back(or_nan(fit.relative_volume));
  }
  return kType(found.enclosed_volume ? py::object(py::float_(*found.enclosed_volume)) : py::none(),
               py::tuple(kinds), array_over<double>(std::move(volumes)),
               array_over<double>(std::move(surfaces)), array_over<double>(std::move(empty)),
               array_over<double>(std::move(relative)));
}

}  // namespace

void add_fits(py::module_& module) {
  module.def("bounding_sphere", &sphere_around, R"(bounding_sphere(mesh)
--

The smallest ball around a mesh, or around points of the shape (n, 3): (centre, radius), metres.

Raises InputError for no points, or for one that is not finite.

>>> centre, radius = graze.bounding_sphere([[0, 0, 0], [2, 0, 0]])
>>> centre, 1 <= radius < 1.0001
(array([1., 0., 0.]), True)
)",
             py::arg("mesh"));
  module.def("bounding_obb", &box_around, R"(bounding_obb(mesh)
--

A turned box around a mesh, or around points of the shape (n, 3), none of whose turns about its axes makes it smaller:
(pose, half_extents), metres. Raises what bounding_sphere() raises.
)",
             py::arg("mesh"));
  module.def("bounding_kdop", &kdop_around, R"(bounding_kdop(mesh)
--

The smallest polytope of nine slabs around a mesh, or around points of the shape (n, 3), rounded outward: a KDop. Raises
what bounding_sphere() raises.

>>> slabs = graze.bounding_kdop(bolt)
>>> bool((slabs.min <= slabs.max).all()), slabs.directions.shape
(True, (9, 3))
)",
             py::arg("mesh"));
  module.def("measure_fit", &measured, R"(measure_fit(mesh)
--

How well boxes, balls and polytopes of slabs fit a mesh: a MeshFit.

>>> graze.measure_fit(bolt).kinds
('aabb', 'sphere', 'obb', 'kdop')
)",
             py::arg("mesh"));
}

}  // namespace graze::python
