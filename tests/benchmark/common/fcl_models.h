#pragma once

// Needs FCL: for the pages of its contestants alone.

#include <fcl/geometry/bvh/BVH_model.h>

#include <graze/bvh/error.h>
#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

#include <memory>
#include <vector>

static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::benchmark {

/// FCL's tree of such volumes over the mesh, built.
template <typename Volume>
std::shared_ptr<fcl::BVHModel<Volume>> to_fcl(const Mesh& mesh) {
  auto model = std::make_shared<fcl::BVHModel<Volume>>();
  std::vector<fcl::Triangle> triangles;
  for (const TriangleIndices& t : mesh.triangles())
    triangles.emplace_back(t[0], t[1], t[2]);
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices().size()));
  model->addSubModel({mesh.vertices().begin(), mesh.vertices().end()}, triangles);
  if (model->endModel() != fcl::BVH_OK) throw Error("FCL refuses a mesh");
  return model;
}

inline fcl::Transform3d to_fcl_pose(const Pose& pose) {
  fcl::Transform3d placed = fcl::Transform3d::Identity();
  placed.linear() = pose.linear();
  placed.translation() = pose.translation();
  return placed;
}

}  // namespace graze::benchmark
