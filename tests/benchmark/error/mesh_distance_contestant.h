#pragma once

#include <graze/engine/mesh/mesh.h>

#include <memory>
#include <utility>
#include <vector>

#include "tests/benchmark/error/contestant.h"

namespace graze::benchmark {

/// A way to say how far two meshes are apart, of which the second is moved.
class MeshDistanceContestant {
 public:
  explicit MeshDistanceContestant(Label label) : label_(std::move(label)) {}
  virtual ~MeshDistanceContestant() = default;

  const Label& label() const { return label_; }

  /// Builds whatever trees it wants, untimed. The meshes outlive the questions.
  virtual void prepare(const Mesh& mesh_a, const Mesh& mesh_b) = 0;
  virtual double distance(const Pose& pose_b) = 0;  ///< metres

 private:
  Label label_;
};

using MeshDistanceContestants = std::vector<std::unique_ptr<MeshDistanceContestant>>;

}  // namespace graze::benchmark
