#pragma once

// Results are tuples with names, whose classes Python has.

#include <graze/engine/python/binding/arguments/arrays.h>

#include <utility>

namespace graze::python {

/// Names a class of graze._results. One is made for each place that makes results.
class ResultType {
 public:
  explicit ResultType(const char* name) : name_(name) {}

  /// Makes an instance with these members, in their order.
  template <typename... Members>
  py::object operator()(Members&&... members) const {
    return make(py::make_tuple(std::forward<Members>(members)...));
  }
  py::object make(const py::tuple& members) const;

 private:
  const char* name_;
  mutable PyTypeObject* type_ = nullptr;  ///< never released: its module stays
};

}  // namespace graze::python
