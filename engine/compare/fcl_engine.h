#pragma once

// Asks FCL, the Flexible Collision Library, the same queries, for a second opinion. No type of FCL
// appears here, so that users need neither its headers nor its compile flags.

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/pair.h>

#include <memory>
#include <vector>

namespace graze::compare {

/// Holds a mesh as FCL sees it: its own copy of the triangles under a tree of OBBs and RSSs. Many
/// threads may query it at once.
class FclMesh {
 public:
  /// Builds FCL's tree in O(n log n). Throws MeshError if FCL refuses the mesh.
  explicit FclMesh(const Mesh& mesh);
  ~FclMesh();
  FclMesh(FclMesh&&) noexcept;
  FclMesh& operator=(FclMesh&&) noexcept;

 private:
  struct Model;
  friend bool intersects(const FclMesh&, const Pose&, const FclMesh&, const Pose&);
  friend std::vector<TrianglePair> find_triangle_pairs(const FclMesh&, const Pose&, const FclMesh&,
                                                       const Pose&);
  friend struct FclDistance distance(const FclMesh&, const Pose&, const FclMesh&, const Pose&);
  friend std::vector<struct FclContact> find_contacts(const FclMesh&, const Pose&, const FclMesh&,
                                                      const Pose&);

  std::unique_ptr<const Model> model_;
};

/// Returns FCL's answer, in plain floating point, so that it may be wrong near touching. FCL stops
/// at the first pair that it finds.
bool intersects(const FclMesh& mesh_a, const Pose& pose_a, const FclMesh& mesh_b,
                const Pose& pose_b);

/// Returns all pairs that FCL finds, in ascending order, each once.
std::vector<TrianglePair> find_triangle_pairs(const FclMesh& mesh_a, const Pose& pose_a,
                                              const FclMesh& mesh_b, const Pose& pose_b);

/// The distance of two surfaces by FCL, which is 0 if FCL finds that they touch.
struct FclDistance {
  double distance;  ///< metres
  TrianglePair pair;
};
FclDistance distance(const FclMesh& mesh_a, const Pose& pose_a, const FclMesh& mesh_b,
                     const Pose& pose_b);

/// Holds one contact of FCL, which makes several of a pair of triangles.
struct FclContact {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;  ///< from A to B; unit unless FCL errs
  double depth;            ///< metres
};
std::vector<FclContact> find_contacts(const FclMesh& mesh_a, const Pose& pose_a,
                                      const FclMesh& mesh_b, const Pose& pose_b);

/// Returns the version of FCL's headers.
const char* fcl_version();

}  // namespace graze::compare
