#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/world/shape.h>

namespace graze::python {

/// Returns a shape as the class of Python that has its kind, a mesh as a Mesh.
py::object object_of(const Shape& shape);

}  // namespace graze::python
