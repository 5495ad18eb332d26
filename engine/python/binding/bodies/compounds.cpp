#include <graze/engine/python/binding/bodies/compounds.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/values/shapes.h>

#include <graze/bvh/error.h>
#include <graze/bvh/value/element_error.h>

#include <string>

namespace graze::python {
namespace {

/// Sets the filter of each part; None stands for that of its body.
void set_filters(Compound& parts, py::handle filters) {
  if (filters.is_none()) return;
  if (!PySequence_Check(filters.ptr()) || py::len(filters) != parts.size())
    throw InputError("filters: are not as many as parts");
  const auto all = py::reinterpret_borrow<py::sequence>(filters);
  for (const std::uint32_t part : parts.parts()) {
    const py::object filter = all[part];
    if (!filter.is_none()) parts.set_settings(part, {.filter = filter_from(filter)});
  }
}

py::object filters_of(const SharedCompound& compound) {
  py::list filters;
  bool has_any = false;
  for (const std::uint32_t part : compound.parts.parts()) {
    const auto& filter = compound.parts.settings(part).filter;
    has_any = has_any || filter;
    filters.append(filter ? py::object(tuple_of(*filter)) : py::none());
  }
  return has_any ? py::object(filters) : py::none();
}

std::unique_ptr<SharedCompound> make_compound(const py::iterable& parts, py::handle filters) {
  auto made = std::make_unique<SharedCompound>();
  for (const py::handle part : parts) {
    const std::size_t index = made->parts.size();
    const std::string name = "parts[" + std::to_string(index) + "]";
    const Placed placed(part, name.c_str());
    if (placed.poses().is_many()) throw InputError(name + ": has many poses");
    bvh::at_element("part", index, [&] {
      placed.check_poses();
      made->parts.add(placed.shape_at(0));
    });
  }
  set_filters(made->parts, filters);
  made->shape = share(made->parts);
  return made;
}

py::list parts_of(const SharedCompound& compound) {
  py::list parts;
  for (const std::uint32_t part : compound.parts.parts()) {
    const PlacedShape& placed = compound.parts.part(part);
    parts.append(py::make_tuple(object_of(placed.shape), array_of(placed.pose)));
  }
  return parts;
}

}  // namespace

PlacedBody::PlacedBody(py::handle argument) {
  py::handle owner = argument;
  py::handle poses = Py_None;
  if (PyTuple_CheckExact(argument.ptr()) && PyTuple_GET_SIZE(argument.ptr()) == 2) {
    owner = PyTuple_GET_ITEM(argument.ptr(), 0);
    poses = PyTuple_GET_ITEM(argument.ptr(), 1);
  }
  const bool is_map = py::isinstance<SharedMap>(owner);
  if (!is_map && !py::isinstance<SharedCompound>(owner)) {
    placed_.emplace(argument, "shape");
    return;
  }
  owner_ = py::reinterpret_borrow<py::object>(owner);
  if (is_map) {
    map_ = owner.cast<SharedMap*>();
  } else {
    compound_ = owner.cast<const SharedCompound*>();
  }
  poses_ = Poses(poses, "pose of shape");
}

std::shared_ptr<const BodyShape> PlacedBody::shape() const {
  if (placed_) return share(placed_->shape());
  if (compound_ != nullptr) return compound_->shape;
  const std::scoped_lock lock(map_->mutex);
  return share(map_->map);
}

py::object object_of(const BodyShape& shape) {
  if (const Shape* known = shape.shape()) return object_of(*known);
  if (const VoxelMap* map = voxel_map_of(shape))
    return py::cast(std::make_shared<SharedMap>(VoxelMap(*map)));
  const Compound* compound = compound_of(shape);
  if (compound == nullptr) return py::none();
  return py::cast(std::make_unique<SharedCompound>(SharedCompound{*compound, share(*compound)}));
}

std::shared_ptr<const BodyShape> body_shape_from(py::handle argument) {
  const PlacedBody body(argument);
  const py::gil_scoped_release released;
  return body.shape();
}

void PlacedBody::check_poses() const {
  if (placed_) {
    placed_->check_poses();
    return;
  }
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const std::string what =
        poses_.is_many() ? "pose " + std::to_string(i) + " of shape" : "pose of shape";
    bvh::at_element("pose", i, [&] { check_rigid(poses_[i], what.c_str()); });
  }
}

void add_compounds(py::module_& module) {
  py::class_<SharedCompound>(
      module, "Compound",
      R"(Several shapes that are one body of a World: Compound(parts, filters=None).

`parts` are meshes and shapes, or tuples of one and its pose in the compound's frame. They may overlap. What a body
meets is what its parts meet; contacts say which parts these are, counted from 0. `filters` has a (category, mask, group)
for each part, or None for that of its body.

Raises InputError for a half-space, a plane and for no parts, and PoseError, with the index.

>>> dumbbell = graze.Compound([graze.Sphere([-1, 0, 0], 0.5), graze.Sphere([1, 0, 0], 0.5)])
>>> world = graze.World()
>>> body = world.add(dumbbell)
>>> ball = world.add(graze.Sphere([1, 0.75, 0], 0.5))
>>> world.update().contacts.parts
array([[1, 0]], dtype=uint32)
)")
      .def(py::init(&make_compound), "__init__(self, parts, filters=None)\n--\n\nSee the class.",
           py::arg("parts"), py::arg("filters") = py::none())
      .def_property_readonly("filters", &filters_of,
                             "The filter of each part, or None if no part has one of its own.")
      .def_property_readonly("parts", &parts_of, "Its parts, each with its pose.")
      .def("__len__", [](const SharedCompound& compound) { return compound.parts.size(); })
      .def("__reduce__", [](const py::object& self) {
        return py::make_tuple(py::type::of(self),
                              py::make_tuple(parts_of(self.cast<const SharedCompound&>()),
                                             filters_of(self.cast<const SharedCompound&>())));
      });
}

}  // namespace graze::python
