#pragma once

// Takes arrays of numpy as arguments and makes them as results.

#include <graze/engine/mesh/mesh.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace graze::python {

namespace py = pybind11;

/// Returns the argument as an array of native, aligned float64 of any strides: itself where it is
/// one, else a copy that has lost nothing. Throws InputError, which names the argument.
py::array doubles(py::handle argument, const char* name);

/// Returns three numbers. Throws InputError for anything else.
Eigen::Vector3d vector_from(py::handle argument, const char* name);

/// Returns a number. Throws InputError for anything else.
double number_from(py::handle argument, const char* name);

/// Returns a number that is not negative. Throws InputError for anything else.
std::size_t count_from(py::handle argument, const char* name);

/// Holds rows of three numbers, read in place.
class Points {
 public:
  /// Takes one point of shape (3,) or n of shape (n, 3). Throws InputError for anything else.
  Points(py::handle argument, const char* name);

  bool is_many() const { return is_many_; }
  std::size_t size() const { return size_; }
  /// Returns the rows as the library takes them: in place, but for arrays that are broadcast or go
  /// backwards.
  MatrixView<double> matrix() const;
  Eigen::Vector3d operator[](std::size_t row) const {
    const char* at = data_ + static_cast<py::ssize_t>(row) * row_stride_;
    return {read(at), read(at + stride_), read(at + 2 * stride_)};
  }

 private:
  static double read(const char* at) { return *reinterpret_cast<const double*>(at); }

  py::array keeper_;
  const char* data_;
  std::size_t size_ = 1;
  bool is_many_;
  py::ssize_t row_stride_ = 0;
  py::ssize_t stride_;
};

/// Makes a new array of one point.
py::object array_of(const Eigen::Vector3d& point);
/// Makes a new array of the shape (4, 4).
py::object array_of_matrix(const double* column_major);

/// Makes a new array whose memory is not set.
template <typename T>
py::array_t<T> new_array(std::vector<py::ssize_t> shape) {
  return py::array_t<T>(std::move(shape));
}

/// Makes an array that takes over what a vector holds, without a copy. Elements that are made of
/// `columns` numbers become rows.
template <typename T, typename Element>
py::array_t<T> array_over(std::vector<Element>&& elements, std::size_t columns = 1) {
  static_assert(sizeof(Element) % sizeof(T) == 0);
  auto* kept = new std::vector<Element>(std::move(elements));
  const py::capsule owner(kept,
                          [](void* memory) { delete static_cast<std::vector<Element>*>(memory); });
  // NOLINTNEXTLINE(bugprone-sizeof-expression): an element may be one number
  constexpr std::size_t kNumbers = sizeof(Element) / sizeof(T);
  const auto rows = static_cast<py::ssize_t>(kept->size() * kNumbers / columns);
  std::vector<py::ssize_t> shape{rows};
  if (columns > 1) shape.push_back(static_cast<py::ssize_t>(columns));
  return py::array_t<T>(shape, reinterpret_cast<const T*>(kept->data()), owner);
}

/// Writes a point into a row of three.
inline void write(const Eigen::Vector3d& point, double* row) {
  row[0] = point.x(), row[1] = point.y(), row[2] = point.z();
}

}  // namespace graze::python
