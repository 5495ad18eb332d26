// graze behind the page that every engine has, so that it is asked and judged as the others are.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/world/shape_pairs.h>

namespace graze::compare {
namespace {

class GrazePair : public LoadedPair {
 public:
  GrazePair(const Mesh& mesh_a, const Mesh& mesh_b) : mesh_a_(mesh_a), mesh_b_(mesh_b) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    CaseMesh a(mesh_a_, pose_a), b(mesh_b_, pose_b);
    a.course = question.course_a;
    b.course = question.course_b;
    const Case query{.note = "",
                     .ask = question.ask,
                     .settings = question.settings,
                     .a = std::move(a),
                     .b = std::move(b),
                     .answer = std::nullopt,
                     .answered_by = {}};
    return answer_case(query);
  }

 private:
  Mesh mesh_a_;
  Mesh mesh_b_;
};

class GrazeShapes : public LoadedShapes {
 public:
  explicit GrazeShapes(std::span<const Shape> shapes) : shapes_(shapes.begin(), shapes.end()) {}

  std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a, std::size_t shape_b,
                                 const Pose& pose_b) const override {
    return graze::intersects({shapes_[shape_a], pose_a}, {shapes_[shape_b], pose_b});
  }

 private:
  std::vector<Shape> shapes_;
};

class GrazeEngine : public Engine {
 public:
  CaseWitness name() const override { return this_library(); }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<GrazePair>(mesh_a, mesh_b);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<GrazeShapes>(shapes);
  }
};

}  // namespace

std::unique_ptr<Engine> make_graze_engine() {
  return std::make_unique<GrazeEngine>();
}

}  // namespace graze::compare
