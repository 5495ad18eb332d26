#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/distance.h>

#include "tests/benchmark/pairs/contestant.h"

namespace graze::benchmark {
namespace {

class GrazePairs final : public PairContestant {
 public:
  explicit GrazePairs(PairVolume volume)
      : PairContestant(std::string("graze ") + graze::name_of(volume)), volume_(volume) {}

  std::string refusal(Question question) const override {
    const bool has_volumes = question == Question::Any || question == Question::Pairs;
    return has_volumes || volume_ == PairVolume::WideObb ? "" : "the volume is no choice here";
  }

  void build(const Mesh& mesh_a, const Mesh& mesh_b) override {
    copy(mesh_a, mesh_b);
    for (const Mesh& mesh : {*mesh_a_, *mesh_b_}) {
      if (volume_ == PairVolume::WideObb) wide_tree_of(mesh).build_all();
      if (volume_ == PairVolume::Aabb) tree_of(mesh);
      if (volume_ == PairVolume::Obb) obb_skin_of(mesh);
    }
  }
  void release() override {
    mesh_a_.reset();
    mesh_b_.reset();
  }

  bool any(const Pose& pose_b) override { return ask(pose_b, nullptr); }
  void find(const Pose& pose_b, std::vector<TrianglePair>& pairs) override {
    pairs = find_triangle_pairs({*mesh_a_}, {*mesh_b_, pose_b}, {.volume = volume_}).pairs;
  }
  double distance(const Pose& pose_b) override {
    return graze::distance({*mesh_a_}, {*mesh_b_, pose_b}).distance;
  }
  bool within(const Pose& pose_b, double clearance) override {
    return graze::within({*mesh_a_}, {*mesh_b_, pose_b}, clearance);
  }

  /// Builds what the query walks, and no more.
  bool any_once(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& pose_b) override {
    copy(mesh_a, mesh_b);
    return any(pose_b);
  }

  std::optional<Work> work(Question question, const Pose& pose_b, double clearance) override {
    Work work;
    const PlacedMeshView a{*mesh_a_};
    const PlacedMeshView b{*mesh_b_, pose_b};
    switch (question) {
      case Question::Any:
        ask(pose_b, &work);
        break;
      case Question::Pairs:
        find_triangle_pairs(a, b, {.volume = volume_}, &work);
        break;
      case Question::Distance:
        graze::distance(a, b, {}, &work);
        break;
      case Question::Within:
        graze::within(a, b, clearance, {}, &work);
        break;
    }
    return work;
  }

 private:
  bool ask(const Pose& pose_b, Work* work) const {
    return intersects({*mesh_a_}, {*mesh_b_, pose_b}, QuerySettings{.volume = volume_}, work);
  }

  void copy(const Mesh& mesh_a, const Mesh& mesh_b) {
    mesh_a_.emplace(mesh_a.vertices(), mesh_a.triangles());
    mesh_b_.emplace(mesh_b.vertices(), mesh_b.triangles());
  }

  PairVolume volume_;
  std::optional<Mesh> mesh_a_;
  std::optional<Mesh> mesh_b_;
};

}  // namespace

void add_graze(PairContestants& contestants) {
  for (const PairVolume volume : {PairVolume::WideObb, PairVolume::Aabb, PairVolume::Obb})
    contestants.push_back(std::make_unique<GrazePairs>(volume));
}

}  // namespace graze::benchmark
