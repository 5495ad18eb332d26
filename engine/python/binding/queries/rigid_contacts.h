#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>

#include <span>
#include <vector>

namespace graze::python {

/// Holds one motion, or RigidMotions, or a list or a tuple of motions.
class Motions {
 public:
  /// Throws as motion_from() does, naming the element.
  Motions(py::handle argument, const char* name);

  bool is_many() const { return is_many_; }
  std::span<const RigidMotion> all() const { return array_ != nullptr ? *array_ : listed_; }
  std::size_t size() const { return all().size(); }
  const RigidMotion& operator[](std::size_t i) const { return all()[i]; }

 private:
  py::object keeper_;
  const std::vector<RigidMotion>* array_;
  std::vector<RigidMotion> listed_;
  bool is_many_;
};

/// Returns RigidContacts of Python.
py::object result_of(const std::vector<RigidContact>& contacts);

}  // namespace graze::python
