// Asks FCL's other methods for a first contact, engines beside "fcl", which is asked with FCL's
// defaults: their answers differ, and whoever uses FCL has to choose one. They know motions alone.

#include <graze/engine/compare/fcl_engine.h>
#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/fcl_motions.h>

#include <algorithm>
#include <array>
#include <string>

namespace graze::compare {
namespace {

struct NamedFclMotion {
  const char* name;
  FclMotionSettings settings;
};

/// Each changes one setting.
constexpr std::array<NamedFclMotion, 12> kNamedMotions = {{
    {"fcl-advancement", {.how = FclContinuous::Advanced}},
    {"fcl-1000", {.samples = 1000, .time_error = 1e-3}},
    {"fcl-swapped", {.order = FclOrder::Swapped}},
    {"fcl-translation", {.course = FclCourse::Translation}},
    {"fcl-screw", {.course = FclCourse::Screw}},
    {"fcl-spline", {.course = FclCourse::Spline}},
    {"fcl-polynomial", {.how = FclContinuous::Polynomial, .course = FclCourse::Translation}},
    {"fcl-advancement-swapped", {.how = FclContinuous::Advanced, .order = FclOrder::Swapped}},
    {"fcl-advancement-indep", {.how = FclContinuous::Advanced, .nearest = FclNearest::Independent}},
    {"fcl-advancement-fine", {.how = FclContinuous::Advanced, .time_error = 1e-8}},
    {"fcl-advancement-translation",
     {.how = FclContinuous::Advanced, .course = FclCourse::Translation}},
    {"fcl-advancement-screw", {.how = FclContinuous::Advanced, .course = FclCourse::Screw}},
}};

class FclMotionPair : public LoadedPair {
 public:
  FclMotionPair(const Mesh& mesh_a, const Mesh& mesh_b, const FclMotionSettings& settings)
      : motions_(std::array{Shape(mesh_a), Shape(mesh_b)}, settings) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    return motions_.answer(question, {0, pose_a}, {1, pose_b});
  }

 private:
  FclMotions motions_;
};

class FclMotionShapes : public LoadedShapes {
 public:
  FclMotionShapes(std::span<const Shape> shapes, const FclMotionSettings& settings)
      : motions_(shapes, settings) {}

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

class FclMotionEngine : public Engine {
 public:
  explicit FclMotionEngine(const NamedFclMotion& motion) : motion_(motion) {}
  CaseWitness name() const override { return {motion_.name, fcl_version()}; }
  std::optional<std::vector<Ask>> questions() const override {
    return std::vector<Ask>{Ask::FirstContact, Ask::Free};
  }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<FclMotionPair>(mesh_a, mesh_b, motion_.settings);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<FclMotionShapes>(shapes, motion_.settings);
  }

 private:
  NamedFclMotion motion_;
};

}  // namespace

std::unique_ptr<Engine> make_fcl_motion_engine(const std::string& name) {
  const auto motion = std::find_if(kNamedMotions.begin(), kNamedMotions.end(),
                                   [&](const NamedFclMotion& each) { return each.name == name; });
  return motion == kNamedMotions.end() ? nullptr : std::make_unique<FclMotionEngine>(*motion);
}

}  // namespace graze::compare
