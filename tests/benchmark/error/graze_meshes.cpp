#include <optional>
#include <string>

#include "tests/benchmark/error/mesh_contestant.h"

namespace graze::benchmark {
namespace {

class GrazeMeshes final : public MeshContestant {
 public:
  explicit GrazeMeshes(PairVolume volume)
      : MeshContestant({std::string("graze, ") + name_of(volume), Origin::Graze, "exact", {}}),
        volume_(volume) {}

  void prepare(const Mesh& mesh_a, const Mesh& mesh_b) override {
    mesh_a_ = mesh_a;
    mesh_b_ = mesh_b;
    any(Pose::Identity());  // builds the trees
  }
  bool any(const Pose& pose_b) override {
    return intersects({*mesh_a_}, {*mesh_b_, pose_b}, QuerySettings{.volume = volume_});
  }
  void find(const Pose& pose_b, std::vector<IndexPair>& pairs) override {
    pairs = find_triangle_pairs({*mesh_a_}, {*mesh_b_, pose_b}, {.volume = volume_}).pairs;
  }

 private:
  PairVolume volume_;
  std::optional<Mesh> mesh_a_;
  std::optional<Mesh> mesh_b_;
};

}  // namespace

void add_graze_meshes(MeshContestants& contestants) {
  for (const PairVolume volume : kPairVolumes)
    contestants.push_back(std::make_unique<GrazeMeshes>(volume));
}

}  // namespace graze::benchmark
