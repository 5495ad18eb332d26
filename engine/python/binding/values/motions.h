#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>

#include <vector>

namespace graze::python {

/// Holds RigidMotions of Python.
struct MotionArray {
  std::vector<RigidMotion> all;
};
/// Returns the motions that RigidMotions hold, or nothing if the argument is no such object.
const std::vector<RigidMotion>* motions_in(py::handle argument);

/// Returns the motion of a RigidMotion, or of a pose that rests. Throws PoseError.
RigidMotion motion_from(py::handle argument, const char* name);
/// Returns a RigidContact of Python.
py::object result_of(const RigidContact& contact);
const char* word_of(RigidStatus status);
/// Returns what first contacts are told. Throws InputError for anything but numbers.
RigidContactSettings contact_settings(py::handle clearance, py::handle tolerance,
                                      py::handle budget);

}  // namespace graze::python
