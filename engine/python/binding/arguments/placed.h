#pragma once

// Takes what queries are asked about: meshes and shapes, in one pose or in many.

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/world/placed_shape.h>

#include <optional>
#include <vector>

namespace graze::python {

/// Holds matrices of the shape (4, 4), (3, 4), (n, 4, 4) or (n, 3, 4), read in place; None is the
/// identity.
class Poses {
 public:
  Poses() = default;
  /// Throws PoseError for another shape, InputError for anything but numbers.
  Poses(py::handle argument, const char* name);

  bool is_many() const { return is_many_; }
  std::size_t size() const { return size_; }
  /// Returns a pose unchecked, as the query checks it.
  Pose operator[](std::size_t index) const { return is_many_ ? read(index) : single_; }

 private:
  Pose read(std::size_t index) const;

  py::object keeper_;
  const char* data_ = nullptr;
  std::size_t size_ = 1;
  bool is_many_ = false;
  bool has_last_row_ = false;
  py::ssize_t stride_ = 0;
  py::ssize_t row_stride_ = 0;
  py::ssize_t column_stride_ = 0;
  Pose single_ = Pose::Identity();  ///< the pose, unless there are many
};

/// Returns one pose. Throws PoseError, also for one that is not rigid.
Pose pose_from(py::handle argument, const char* name);
/// Returns the array of a pose.
inline py::object array_of(const Pose& pose) {
  return array_of_matrix(pose.matrix().data());
}

/// Holds a mesh or a shape, where it is, or with its poses.
class Placed {
 public:
  /// Takes the argument `name`. Throws TypeError for what is neither of the two, nor a pair of one
  /// of them and a pose.
  Placed(py::handle argument, const char* name);

  bool is_mesh() const { return mesh_ != nullptr; }
  const Mesh& mesh() const { return *mesh_; }
  /// Returns the shape, for a mesh, too.
  const Shape& shape() const;
  const Poses& poses() const { return poses_; }
  const char* name() const { return name_; }

  PlacedMeshView mesh_at(std::size_t index) const {
    return {*mesh_, poses_[poses_.is_many() ? index : 0]};
  }
  PlacedShape shape_at(std::size_t index) const {
    return {shape(), poses_[poses_.is_many() ? index : 0]};
  }

  /// Throws PoseError, with its index, for the first pose that is refused.
  void check_poses() const;

 private:
  const char* name_;
  py::object owner_;
  const Mesh* mesh_ = nullptr;
  const Shape* shape_ = nullptr;
  mutable std::optional<Shape> shape_of_mesh_;
  Poses poses_;
};

/// Takes an argument of queries of meshes alone. Throws TypeError for a shape.
Placed placed_mesh(py::handle argument, const char* name);

/// Holds two of them, in as many poses: where both have many, they have equally many.
class PlacedPair {
 public:
  /// Throws InputError for different numbers of poses.
  PlacedPair(py::handle argument_a, py::handle argument_b);

  bool are_meshes() const { return a.is_mesh() && b.is_mesh(); }
  bool is_many() const { return a.poses().is_many() || b.poses().is_many(); }
  std::size_t size() const { return a.poses().is_many() ? a.poses().size() : b.poses().size(); }
  /// Throws as Placed does.
  void check_poses() const;
  /// Throws TypeError unless both are meshes, in words about `query`.
  void require_meshes(const char* query) const;

  Placed a;
  Placed b;
};

}  // namespace graze::python
