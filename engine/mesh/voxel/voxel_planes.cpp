#include <graze/engine/mesh/voxel/voxel_planes.h>

#include <algorithm>

namespace graze {

int VoxelBlock::longest_axis() const {
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (length(axis) > length(longest)) longest = axis;
  }
  return longest;
}

// The local frame has room for the mesh alone: a plane beyond the bounds, of which there is one at
// most along each axis, is represented by the bounds' end. No point of the mesh lies between.
VoxelPlanes::VoxelPlanes(const VoxelGrid& grid, const bvh::LocalFrame& frame, const Aabb& bounds) {
  for (int axis = 0; axis < 3; ++axis) {
    for (std::uint32_t index = 0; index <= grid.counts[axis]; ++index) {
      const double at = grid.plane(axis, index);
      Eigen::Vector3d point = bounds.max;
      point.data()[axis] = std::min(at, bounds.max.data()[axis]);
      const bvh::FloatBox local = frame.to_local({point, point});
      planes_[axis].push_back({at, local.min[axis], local.max[axis]});
    }
  }
}

Aabb VoxelPlanes::box(const VoxelBlock& block) const {
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min.data()[axis] = planes_[axis][block.first[axis]].at;
    box.max.data()[axis] = planes_[axis][block.last[axis]].at;
  }
  return box;
}

bvh::FloatBox VoxelPlanes::local_box(const VoxelBlock& block) const {
  bvh::FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = planes_[axis][block.first[axis]].local_below;
    box.max[axis] = planes_[axis][block.last[axis]].local_above;
  }
  return box;
}

Eigen::Vector3d VoxelPlanes::first_corner(const VoxelBlock& block) const {
  return {planes_[0][block.first[0]].at, planes_[1][block.first[1]].at,
          planes_[2][block.first[2]].at};
}

bvh::FloatBox VoxelPlanes::local_first_corner(const VoxelBlock& block) const {
  bvh::FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = planes_[axis][block.first[axis]].local_below;
    box.max[axis] = planes_[axis][block.first[axis]].local_above;
  }
  return box;
}

}  // namespace graze
