// Asks graze through the interface that every engine has, so that it is asked and judged as the
// others are.

#include <graze/bvh/error.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/peers/graze_answer.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>

#include <utility>

namespace graze::compare {
namespace {

class GrazePair : public LoadedPair {
 public:
  GrazePair(const Mesh& mesh_a, const Mesh& mesh_b) : mesh_a_(mesh_a), mesh_b_(mesh_b) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    return graze_answer(question, CaseMesh(mesh_a_, pose_a), CaseMesh(mesh_b_, pose_b));
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

  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const override {
    if (cases::is_about_motion(question.ask)) return answer_about_motions(question, a, b);
    return graze_answer(question, CaseBody(shapes_[a.shape], a.pose),
                        CaseBody(shapes_[b.shape], b.pose));
  }

 private:
  /// Answers about height fields as they stand, which a case holds as meshes.
  std::optional<CaseAnswer> answer_about_motions(const Question& question, const PlacedShape& a,
                                                 const PlacedShape& b) const {
    const auto motion = [](const PlacedShape& placed, const std::optional<RigidCourse>& course) {
      return course ? RigidMotion(placed.pose, *course) : RigidMotion(placed.pose);
    };
    const RigidMotion motion_a = motion(a, question.course_a);
    const RigidMotion motion_b = motion(b, question.course_b);
    const RigidContactSettings settings = contact_settings(question.settings);
    const Shape &shape_a = shapes_[a.shape], &shape_b = shapes_[b.shape];
    try {
      if (question.ask == Ask::FirstContact)
        return answer_of(first_contact({shape_a, motion_a}, {shape_b, motion_b}, settings));
      CaseAnswer answer;
      answer.says = is_free({shape_a, motion_a}, {shape_b, motion_b}, settings);
      return answer;
    } catch (const UnsupportedPairError&) {
      return std::nullopt;
    }
  }

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
