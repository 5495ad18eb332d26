#include <graze/engine/compare/peers/graze_answer.h>
#include <graze/engine/compare/run/shape_pair.h>

#include <array>
#include <utility>

namespace graze::compare {
namespace {

/// Holds two shapes for graze itself, which knows every question.
class GrazeShapePair : public LoadedPair {
 public:
  GrazeShapePair(const Shape& shape_a, const Shape& shape_b) : a_(shape_a), b_(shape_b) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    return graze_answer(question, CaseBody(a_, pose_a), CaseBody(b_, pose_b));
  }

 private:
  Shape a_;
  Shape b_;
};

class OtherShapePair : public LoadedPair {
 public:
  explicit OtherShapePair(std::unique_ptr<LoadedShapes> shapes) : shapes_(std::move(shapes)) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    if (!question.is_plain()) return std::nullopt;
    if (question.ask != Ask::Any) return shapes_->answer(question, {0, pose_a}, {1, pose_b});
    const std::optional<bool> says = shapes_->intersects(0, pose_a, 1, pose_b);
    std::optional<CaseAnswer> answer;
    if (says) answer.emplace().says = says;
    return answer;
  }

 private:
  std::unique_ptr<LoadedShapes> shapes_;
};

}  // namespace

std::unique_ptr<LoadedPair> load_shape_pair(const Engine& engine, const Shape& shape_a,
                                            const Shape& shape_b) {
  if (engine.name().engine == "graze") return std::make_unique<GrazeShapePair>(shape_a, shape_b);
  const std::array<Shape, 2> shapes = {shape_a, shape_b};
  std::unique_ptr<LoadedShapes> loaded = engine.load_shapes(shapes);
  return loaded ? std::make_unique<OtherShapePair>(std::move(loaded)) : nullptr;
}

}  // namespace graze::compare
