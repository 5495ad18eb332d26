// FCL's conservative advancement, an engine beside "fcl", which samples: their answers differ, and
// whoever uses FCL has to choose. It knows motions alone.

#include <graze/engine/compare/fcl_engine.h>
#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/fcl_motions.h>

#include <array>

namespace graze::compare {
namespace {

class FclAdvancementPair : public LoadedPair {
 public:
  FclAdvancementPair(const Mesh& mesh_a, const Mesh& mesh_b)
      : motions_(std::array{Shape(mesh_a), Shape(mesh_b)}, FclContinuous::Advanced) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    return motions_.answer(question, {0, pose_a}, {1, pose_b});
  }

 private:
  FclMotions motions_;
};

class FclAdvancementShapes : public LoadedShapes {
 public:
  explicit FclAdvancementShapes(std::span<const Shape> shapes)
      : motions_(shapes, FclContinuous::Advanced) {}

  std::optional<bool> intersects(std::size_t, const Pose&, std::size_t,
                                 const Pose&) const override {
    return std::nullopt;
  }
  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const override {
    return motions_.answer(question, a, b);
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
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<FclAdvancementShapes>(shapes);
  }
};

}  // namespace

std::unique_ptr<Engine> make_fcl_advancement_engine() {
  return std::make_unique<FclAdvancementEngine>();
}

}  // namespace graze::compare
