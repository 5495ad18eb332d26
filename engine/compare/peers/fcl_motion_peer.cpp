// FCL's other ways to a first contact, engines beside "fcl", which is asked with FCL's defaults:
// their answers differ, and whoever uses FCL has to choose one. They know motions alone.

#include <graze/engine/compare/fcl_engine.h>
#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/fcl_motions.h>

#include <algorithm>
#include <array>
#include <string>

namespace graze::compare {
namespace {

struct NamedWay {
  const char* name;
  FclMotionSettings settings;
};

/// One setting at a time.
constexpr std::array<NamedWay, 12> kWays = {{
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

class FclWayPair : public LoadedPair {
 public:
  FclWayPair(const Mesh& mesh_a, const Mesh& mesh_b, const FclMotionSettings& settings)
      : motions_(std::array{Shape(mesh_a), Shape(mesh_b)}, settings) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    return motions_.answer(question, {0, pose_a}, {1, pose_b});
  }

 private:
  FclMotions motions_;
};

class FclWayShapes : public LoadedShapes {
 public:
  FclWayShapes(std::span<const Shape> shapes, const FclMotionSettings& settings)
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

class FclWayEngine : public Engine {
 public:
  explicit FclWayEngine(const NamedWay& way) : way_(way) {}
  CaseWitness name() const override { return {way_.name, fcl_version()}; }
  std::optional<std::vector<Ask>> questions() const override {
    return std::vector<Ask>{Ask::FirstContact, Ask::Free};
  }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<FclWayPair>(mesh_a, mesh_b, way_.settings);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<FclWayShapes>(shapes, way_.settings);
  }

 private:
  NamedWay way_;
};

}  // namespace

std::unique_ptr<Engine> make_fcl_motion_engine(const std::string& name) {
  const auto way = std::find_if(kWays.begin(), kWays.end(),
                                [&](const NamedWay& each) { return each.name == name; });
  return way == kWays.end() ? nullptr : std::make_unique<FclWayEngine>(*way);
}

}  // namespace graze::compare
