// FCL's conservative advancement, an engine beside "fcl", which samples: their answers differ, and
// whoever uses FCL has to choose. It knows motions alone.

#include <graze/engine/compare/fcl_engine.h>
#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/fcl_motions.h>

namespace graze::compare {
namespace {

class FclAdvancementPair : public LoadedPair {
 public:
  FclAdvancementPair(const Mesh& mesh_a, const Mesh& mesh_b)
      : motions_(mesh_a, mesh_b, FclContinuous::Advanced) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    return motions_.answer(question, pose_a, pose_b);
  }

 private:
  FclMotions motions_;
};

class FclAdvancementEngine : public Engine {
 public:
  CaseWitness name() const override { return {"fcl-advancement", fcl_version()}; }
  std::optional<std::vector<Ask>> questions() const override {
    return std::vector<Ask>{Ask::FirstContact, Ask::Free};
  }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<FclAdvancementPair>(mesh_a, mesh_b);
  }
};

}  // namespace

std::unique_ptr<Engine> make_fcl_advancement_engine() {
  return std::make_unique<FclAdvancementEngine>();
}

}  // namespace graze::compare
