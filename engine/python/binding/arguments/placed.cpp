#include <graze/engine/python/binding/arguments/placed.h>

#include <graze/bvh/error.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shape_bounds.h>

#include <string>

namespace graze::python {
namespace {

/// Casts an object. Types are looked up once: pybind11 would do it for each argument of each call.
template <typename T>
T* as(py::handle object) {
  static PyTypeObject* const type =
      reinterpret_cast<PyTypeObject*>(py::type::of<T>().release().ptr());
  if (Py_TYPE(object.ptr()) != type && !PyType_IsSubtype(Py_TYPE(object.ptr()), type))
    return nullptr;
  return object.cast<T*>();
}

std::string wrong_shape(const py::array& array, const char* name) {
  return std::string(name) + ": the shape " +
         py::str(py::tuple(array.attr("shape"))).cast<std::string>() +
         " is none of (4, 4), (3, 4), (n, 4, 4) and (n, 3, 4)";
}

}  // namespace

Poses::Poses(py::handle argument, const char* name) {
  if (argument.is_none()) return;
  const py::array array = doubles(argument, name);
  const py::ssize_t dimensions = array.ndim();
  if ((dimensions != 2 && dimensions != 3) || array.shape(dimensions - 1) != 4 ||
      (array.shape(dimensions - 2) != 4 && array.shape(dimensions - 2) != 3)) {
    throw PoseError(wrong_shape(array, name));
  }
  data_ = static_cast<const char*>(array.data());
  is_many_ = dimensions == 3;
  has_last_row_ = array.shape(dimensions - 2) == 4;
  row_stride_ = array.strides(dimensions - 2);
  column_stride_ = array.strides(dimensions - 1);
  if (is_many_) {
    size_ = static_cast<std::size_t>(array.shape(0));
    stride_ = array.strides(0);
  }
  keeper_ = array;
  if (!is_many_) single_ = read(0);
}

Pose Poses::read(std::size_t index) const {
  Pose pose;
  const char* row = data_ + static_cast<py::ssize_t>(index) * stride_;
  constexpr auto kSize = static_cast<py::ssize_t>(sizeof(double));
  if (has_last_row_ && column_stride_ == kSize && row_stride_ == 4 * kSize) {
    using Rows = Eigen::Matrix<double, 4, 4, Eigen::RowMajor | Eigen::DontAlign>;
    pose.matrix() = Eigen::Map<const Rows>(reinterpret_cast<const double*>(row));
    return pose;
  }
  double* entries = pose.matrix().data();
  for (int i = 0; i < (has_last_row_ ? 4 : 3); ++i, row += row_stride_) {
    const char* at = row;
    for (int j = 0; j < 4; ++j, at += column_stride_) {
      entries[4 * j + i] = *reinterpret_cast<const double*>(at);
    }
  }
  if (!has_last_row_) entries[3] = 0, entries[7] = 0, entries[11] = 0, entries[15] = 1;
  return pose;
}

Pose pose_from(py::handle argument, const char* name) {
  const Poses poses(argument, name);
  if (poses.is_many()) throw PoseError(std::string(name) + ": is one pose, not many");
  const Pose pose = poses[0];
  check_rigid(pose, name);
  return pose;
}

Placed::Placed(py::handle argument, const char* name) : name_(name) {
  py::handle owner = argument;
  py::handle poses = Py_None;
  if (PyTuple_CheckExact(argument.ptr()) && PyTuple_GET_SIZE(argument.ptr()) == 2) {
    owner = PyTuple_GET_ITEM(argument.ptr(), 0);
    poses = PyTuple_GET_ITEM(argument.ptr(), 1);
  }
  mesh_ = as<Mesh>(owner);
  if (mesh_ == nullptr) shape_ = as<Shape>(owner);
  if (mesh_ == nullptr && shape_ == nullptr) {
    throw py::type_error(
        std::string(name) + ": " + Py_TYPE(argument.ptr())->tp_name +
        " is neither a graze.Mesh nor a graze.Shape, nor a tuple (one of them, pose)");
  }
  owner_ = py::reinterpret_borrow<py::object>(owner);
  if (!poses.is_none()) poses_ = Poses(poses, (std::string("pose of ") + name).c_str());
}

const Shape& Placed::shape() const {
  if (shape_ != nullptr) return *shape_;
  if (!shape_of_mesh_) shape_of_mesh_.emplace(*mesh_);
  return *shape_of_mesh_;
}

void Placed::check_poses() const {
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const auto check = [&] {
      const std::string what = poses_.is_many() ? "pose " + std::to_string(i) + " of " + name_
                                                : std::string("pose of ") + name_;
      if (is_mesh()) {
        check_placement(poses_[i], mesh_->bounds(), what.c_str());
      } else {
        check_pose(poses_[i], what.c_str());
      }
    };
    poses_.is_many() ? bvh::at_element("pose", i, check) : check();
  }
}

Placed placed_mesh(py::handle argument, const char* name) {
  Placed placed(argument, name);
  if (!placed.is_mesh())
    throw py::type_error(std::string(name) + ": is a shape; this is asked about meshes");
  return placed;
}

PlacedPair::PlacedPair(py::handle argument_a, py::handle argument_b)
    : a(argument_a, "a"), b(argument_b, "b") {
  if (a.poses().is_many() && b.poses().is_many() && a.poses().size() != b.poses().size()) {
    throw InputError("b: has " + std::to_string(b.poses().size()) + " poses, and a has " +
                     std::to_string(a.poses().size()));
  }
  if (!are_meshes()) {
    // They are made once, before threads ask for them.
    static_cast<void>(a.shape());
    static_cast<void>(b.shape());
  }
}

void PlacedPair::check_poses() const {
  a.check_poses();
  b.check_poses();
}

void PlacedPair::require_meshes(const char* query) const {
  for (const Placed* placed : {&a, &b}) {
    if (!placed->is_mesh()) {
      throw py::type_error(std::string(placed->name()) + ": is a shape; " + query +
                           "() is asked about meshes");
    }
  }
}

}  // namespace graze::python
