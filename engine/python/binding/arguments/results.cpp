#include <graze/engine/python/binding/arguments/results.h>

namespace graze::python {

py::object ResultType::make(const py::tuple& members) const {
  if (type_ == nullptr) {
    py::object found = py::module_::import("graze._results").attr(name_);
    type_ = reinterpret_cast<PyTypeObject*>(found.release().ptr());
  }
  // This does what tuple.__new__(type, members) does.
  const py::tuple arguments(py::make_tuple(members));
  PyObject* made = PyTuple_Type.tp_new(type_, arguments.ptr(), nullptr);
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(made);
}

}  // namespace graze::python
