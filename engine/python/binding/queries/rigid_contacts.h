#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>

#include <vector>

namespace graze::python {

/// One motion, or a list or a tuple of them.
class Motions {
 public:
  /// Throws as motion_from() does, naming the element.
  Motions(py::handle argument, const char* name);

  bool is_many() const { return is_many_; }
  std::size_t size() const { return all_.size(); }
  const RigidMotion& operator[](std::size_t i) const { return all_[i]; }

 private:
  std::vector<RigidMotion> all_;
  bool is_many_;
};

/// RigidContacts of Python.
py::object result_of(const std::vector<RigidContact>& contacts);

}  // namespace graze::python
