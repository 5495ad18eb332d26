#pragma once

#include <graze/engine/mesh/pair.h>

#include <memory>
#include <utility>
#include <vector>

#include "tests/benchmark/error/contestant.h"

namespace graze::benchmark {

/// A triangle of one mesh and a triangle of another, by their indices.
using IndexPair = graze::TrianglePair;

/// A way to answer questions about two meshes of which the second is moved.
class MeshContestant {
 public:
  explicit MeshContestant(Label label) : label_(std::move(label)) {}
  virtual ~MeshContestant() = default;

  const Label& label() const { return label_; }

  /// Builds whatever trees it wants, untimed. The meshes outlive the questions.
  virtual void prepare(const Mesh& mesh_a, const Mesh& mesh_b) = 0;
  virtual bool any(const Pose& pose_b) = 0;

  /// All pairs of triangles that intersect, in any order; `pairs` keeps its memory.
  virtual void find(const Pose& pose_b, std::vector<IndexPair>& pairs) = 0;

 private:
  Label label_;
};

using MeshContestants = std::vector<std::unique_ptr<MeshContestant>>;

/// The library with each of its volumes.
void add_graze_meshes(MeshContestants& contestants);

}  // namespace graze::benchmark
