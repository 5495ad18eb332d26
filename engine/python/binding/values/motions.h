#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>

namespace graze::python {

/// A RigidMotion, or a pose that rests. Throws PoseError.
RigidMotion motion_from(py::handle argument, const char* name);
/// A RigidContact of Python.
py::object result_of(const RigidContact& contact);
const char* word_of(RigidStatus status);

}  // namespace graze::python
