#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/world/height_field.h>

namespace graze::python {

/// Makes a field from what HeightField of Python was called with: heights, (spacing_x, spacing_y),
/// height_scale, height_offset, holes, materials. Throws InputError.
HeightField field_from(const py::args& arguments);

/// Returns what field_from() takes to make an equal field.
py::tuple arguments_of(const HeightField& field);

}  // namespace graze::python
