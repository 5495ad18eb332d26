#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/world/manifold.h>

#include <vector>

namespace graze::python {

/// Returns contacts as the arrays of ShapeContacts.
py::object result_of(const std::vector<ShapeContact>& contacts);

}  // namespace graze::python
