#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <memory>
#include <optional>

namespace graze::samples {

struct Opinion {
  bool is_hit;
  std::size_t pairs;
  double hit_microseconds;    ///< for is_hit alone
  double pairs_microseconds;  ///< for all pairs
};

/// Another library's view of two meshes, the second one in a pose.
class SecondOpinion {
 public:
  SecondOpinion(const Mesh& mesh_a, const Mesh& mesh_b);
  ~SecondOpinion();

  /// What FCL answers, and how long it takes; nothing if the samples were built without FCL.
  std::optional<Opinion> on(const Pose& pose_b) const;

 private:
  struct Models;
  std::unique_ptr<const Models> models_;
};

}  // namespace graze::samples
