#pragma once

#include <graze/engine/python/binding/arguments/placed.h>

#include <graze/engine/python/binding/bodies/voxel_maps.h>
#include <graze/engine/world/compound.h>

#include <memory>

namespace graze::python {

/// Holds several shapes that are one body, as a world takes them.
struct SharedCompound {
  Compound parts;
  std::shared_ptr<const BodyShape> shape;
};

/// Returns what a body of a world has: a mesh or a shape, a Compound or a VoxelMap of Python.
py::object object_of(const BodyShape& shape);

/// Returns the shape that an object of Python stands for. Throws TypeError for any other object.
std::shared_ptr<const BodyShape> body_shape_from(py::handle argument);

/// Holds a body that a world is to have: a mesh, a shape, a compound or a map of voxels, and its
/// poses.
class PlacedBody {
 public:
  /// Throws TypeError for anything else.
  explicit PlacedBody(py::handle argument);

  std::shared_ptr<const BodyShape> shape() const;
  const Poses& poses() const { return placed_ ? placed_->poses() : poses_; }
  /// Throws as Placed does.
  void check_poses() const;

 private:
  std::optional<Placed> placed_;
  py::object owner_;
  const SharedCompound* compound_ = nullptr;
  SharedMap* map_ = nullptr;
  Poses poses_;
};

}  // namespace graze::python
