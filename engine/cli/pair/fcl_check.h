#pragma once

#include <memory>

#include <graze/engine/compare/compare.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>

namespace graze::cli {

/// Asks FCL what graze has answered, for one pair of meshes in any poses.
class FclCheck {
 public:
  virtual ~FclCheck() = default;

  /// Compares a complete list of pairs.
  virtual compare::Comparison check_pairs(const TrianglePairs& graze_pairs, const Pose& pose_a,
                                          const Pose& pose_b) const = 0;

  /// Compares a boolean answer.
  virtual compare::Comparison check_any(bool graze_intersects, const Pose& pose_a,
                                        const Pose& pose_b) const = 0;
};

/// True if this command was built with FCL.
bool has_fcl_check();

/// Builds FCL's trees over both meshes. Throws UsageError if the command was built without FCL.
std::unique_ptr<FclCheck> make_fcl_check(const Mesh& mesh_a, const Mesh& mesh_b);

}  // namespace graze::cli
