#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>

#include <vector>

namespace graze::python {

/// RigidMotions of Python.
struct MotionArray {
  std::vector<RigidMotion> all;
};
/// What these hold, or nothing if the argument is none of them.
const std::vector<RigidMotion>* motions_in(py::handle argument);

/// A RigidMotion, or a pose that rests. Throws PoseError.
RigidMotion motion_from(py::handle argument, const char* name);
/// A RigidContact of Python.
py::object result_of(const RigidContact& contact);
const char* word_of(RigidStatus status);
/// What first contacts are told. Throws InputError for what are no numbers.
RigidContactSettings contact_settings(py::handle clearance, py::handle tolerance,
                                      py::handle budget);

}  // namespace graze::python
