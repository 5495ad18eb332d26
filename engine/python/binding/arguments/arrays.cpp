#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/bvh/error.h>

#include <algorithm>
#include <string>

namespace graze::python {
namespace {

PyObject* double_descriptor() {
  static PyObject* const descriptor = py::dtype::of<double>().release().ptr();
  return descriptor;
}

bool is_plain(py::handle argument) {
  const auto& api = py::detail::npy_api::get();
  if (!api.PyArray_Check_(argument.ptr())) return false;
  const auto* array = py::detail::array_proxy(argument.ptr());
  return array->descr == double_descriptor() &&
         (array->flags & py::detail::npy_api::NPY_ARRAY_ALIGNED_) != 0;
}

std::string shape_text(const py::array& array) {
  return py::str(py::tuple(array.attr("shape"))).cast<std::string>();
}

py::object new_doubles(int dimensions, const py::ssize_t* shape) {
  auto& api = py::detail::npy_api::get();
  Py_INCREF(double_descriptor());  // the call takes over one reference
  PyObject* made =
      api.PyArray_NewFromDescr_(api.PyArray_Type_, double_descriptor(), dimensions,
                                const_cast<py::ssize_t*>(shape), nullptr, nullptr, 0, nullptr);
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(made);
}

double* data_of(const py::object& array) {
  return reinterpret_cast<double*>(py::detail::array_proxy(array.ptr())->data);
}

}  // namespace

py::array doubles(py::handle argument, const char* name) {
  if (is_plain(argument)) return py::reinterpret_borrow<py::array>(argument);
  return py::module_::import("graze._arrays").attr("doubles")(argument, name).cast<py::array>();
}

Eigen::Vector3d vector_from(py::handle argument, const char* name) {
  const Points points(argument, name);
  if (points.is_many()) {
    throw InputError(std::string(name) + ": is one point of the shape (3,), not many");
  }
  return points[0];
}

double number_from(py::handle argument, const char* name) {
  const double value = PyFloat_AsDouble(argument.ptr());
  if (value == -1.0 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw InputError(std::string(name) + ": " + py::repr(argument).cast<std::string>() +
                     " is not a number");
  }
  return value;
}

std::size_t count_from(py::handle argument, const char* name) {
  const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(argument.ptr()));
  const std::size_t value = index ? PyLong_AsSize_t(index.ptr()) : 0;
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw InputError(std::string(name) + ": " + py::repr(argument).cast<std::string>() +
                     " is not a whole number from 0 on");
  }
  return value;
}

Points::Points(py::handle argument, const char* name)
    : keeper_(doubles(argument, name)),
      data_(static_cast<const char*>(keeper_.data())),
      is_many_(keeper_.ndim() == 2) {
  const py::ssize_t dimensions = keeper_.ndim();
  if (dimensions < 1 || dimensions > 2 || keeper_.shape(dimensions - 1) != 3) {
    throw InputError(std::string(name) + ": the shape " + shape_text(keeper_) +
                     " is neither (3,) nor (n, 3)");
  }
  stride_ = keeper_.strides(dimensions - 1);
  if (is_many_) {
    size_ = static_cast<std::size_t>(keeper_.shape(0));
    row_stride_ = keeper_.strides(0);
  }
}

MatrixView<double> Points::matrix() const {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  constexpr auto kSize = static_cast<py::ssize_t>(sizeof(double));
  const auto rows = static_cast<Eigen::Index>(size_);
  if (stride_ > 0 && (row_stride_ > 0 || rows <= 1)) {
    using Strides = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;
    const Strides strides(stride_ / kSize, std::max(row_stride_ / kSize, py::ssize_t{1}));
    return Eigen::Map<const Eigen::MatrixXd, 0, Strides>(reinterpret_cast<const double*>(data_),
                                                         rows, 3, strides);
  }
  Rows copy(rows, 3);  // it may be of another storage order, and what is returned keeps a copy of
                       // its own
  for (Eigen::Index i = 0; i < rows; ++i)
    copy.row(i) = (*this)[static_cast<std::size_t>(i)].transpose();
  return copy;
}

py::object array_of(const Eigen::Vector3d& point) {
  constexpr py::ssize_t kShape[] = {3};
  py::object made = new_doubles(1, kShape);
  write(point, data_of(made));
  return made;
}

py::object array_of_matrix(const double* column_major) {
  constexpr py::ssize_t kShape[] = {4, 4};
  py::object made = new_doubles(2, kShape);
  double* row_major = data_of(made);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      row_major[4 * row + column] = column_major[4 * column + row];
    }
  }
  return made;
}

}  // namespace graze::python
