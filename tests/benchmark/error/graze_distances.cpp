#include <graze/engine/mesh/distance.h>
#include <graze/narrowphase/triangle_distance.h>

#include <memory>
#include <optional>

#include "tests/benchmark/error/graze_parts.h"

namespace graze::benchmark {
namespace {

class GrazeMeshDistances final : public MeshDistanceContestant {
 public:
  GrazeMeshDistances() : MeshDistanceContestant(exact("graze")) {}

  void prepare(const Mesh& mesh_a, const Mesh& mesh_b) override {
    mesh_a_ = mesh_a;
    mesh_b_ = mesh_b;
    distance(Pose::Identity());  // builds the trees
  }
  double distance(const Pose& pose_b) override {
    return graze::distance({*mesh_a_}, {*mesh_b_, pose_b}).distance;
  }

 private:
  std::optional<Mesh> mesh_a_;
  std::optional<Mesh> mesh_b_;
};

}  // namespace

void add_graze_distances(Field& field) {
  add(
      field.distances, exact("graze"), [](const TrianglePair& pair) { return pair; },
      [](const TrianglePair& pair) { return graze::distance(pair.a, pair.b).distance; });
  field.mesh_distances.push_back(std::make_unique<GrazeMeshDistances>());
}

}  // namespace graze::benchmark
