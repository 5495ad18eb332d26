#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

namespace graze {

/// A mesh in a pose: a value, which holds a handle to the mesh.
struct PlacedMesh {
  Mesh mesh;                     ///< a handle
  Pose pose = Pose::Identity();  ///< takes points of the mesh's frame to the common one

  bool operator==(const PlacedMesh& other) const {
    return mesh == other.mesh && are_equal(pose, other.pose);
  }
};

/// A mesh in a pose as queries take it: made of a PlacedMesh or within the call itself, as in
/// `intersects({bolt}, {nut, pose})`. It refers to the mesh, which must outlive it, as everything
/// does that stands within a call; to keep one, keep a PlacedMesh. If it held a handle, a query
/// would count handles up and down, which takes half as long as to find two meshes far apart, and
/// threads that ask about one mesh would wait for each other.
struct PlacedMeshView {
  // NOLINTBEGIN(google-explicit-constructor): queries are asked about meshes and placed meshes
  /// A mesh where it is, in a pose, or as a value that is kept.
  PlacedMeshView(const Mesh& of_mesh) : mesh(of_mesh) {}
  PlacedMeshView(const Mesh& of_mesh, const Pose& in_pose) : mesh(of_mesh), pose(in_pose) {}
  PlacedMeshView(const PlacedMesh& placed) : mesh(placed.mesh), pose(placed.pose) {}
  // NOLINTEND(google-explicit-constructor)

  const Mesh& mesh;              ///< must outlive this
  Pose pose = Pose::Identity();  ///< a copy
};

}  // namespace graze
