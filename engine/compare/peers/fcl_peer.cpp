// Asks FCL through the interface that every engine has. fcl_engine.h does the work.

#include <graze/engine/compare/fcl_engine.h>
#include <graze/engine/compare/fcl_shapes.h>
#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/fcl_motions.h>
#include <graze/engine/compare/peers/shape_answers.h>

#include <array>

namespace graze::compare {
namespace {

class FclPair : public LoadedPair {
 public:
  FclPair(const Mesh& mesh_a, const Mesh& mesh_b)
      : mesh_a_(mesh_a),
        mesh_b_(mesh_b),
        motions_(std::array{Shape(mesh_a), Shape(mesh_b)}, FclMotionSettings{}) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    if (!question.is_plain()) return std::nullopt;
    CaseAnswer answer;
    switch (question.ask) {
      case Ask::Any:
        answer.says = intersects(mesh_a_, pose_a, mesh_b_, pose_b);
        return answer;
      case Ask::Pairs:
        answer.pairs = find_triangle_pairs(mesh_a_, pose_a, mesh_b_, pose_b);
        return answer;
      case Ask::Distance: {
        const FclDistance gap = distance(mesh_a_, pose_a, mesh_b_, pose_b);
        answer.distance = gap.distance;
        answer.pair = gap.pair;
        return answer;
      }
      case Ask::Within:
        answer.says =
            distance(mesh_a_, pose_a, mesh_b_, pose_b).distance <= question.settings.clearance;
        return answer;
      case Ask::Contacts:
        answer.contacts.emplace();
        for (const FclContact& c : find_contacts(mesh_a_, pose_a, mesh_b_, pose_b))
          answer.contacts->push_back({c.point, c.point, c.point, c.normal, c.depth});
        return answer;
      default:
        return motions_.answer(question, {0, pose_a}, {1, pose_b});
    }
  }

 private:
  FclMesh mesh_a_;
  FclMesh mesh_b_;
  FclMotions motions_;
};

class FclShapes : public LoadedShapes {
 public:
  explicit FclShapes(std::span<const Shape> shapes) : motions_(shapes, FclMotionSettings{}) {
    for (const Shape& shape : shapes)
      shapes_.emplace_back(shape);
  }

  std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a, std::size_t shape_b,
                                 const Pose& pose_b) const override {
    return compare::intersects(shapes_[shape_a], pose_a, shapes_[shape_b], pose_b);
  }

  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const override {
    const FclShape& shape_a = shapes_[a.shape];
    const FclShape& shape_b = shapes_[b.shape];
    switch (question.ask) {
      case Ask::Distance:
        return answer_of_distance(compare::distance(shape_a, a.pose, shape_b, b.pose));
      case Ask::Within:
        return answer_of_within(compare::distance(shape_a, a.pose, shape_b, b.pose),
                                question.settings.clearance);
      case Ask::Contacts:
        return contacts(shape_a, a.pose, shape_b, b.pose);
      case Ask::Separation: {
        const auto found = contacts(shape_a, a.pose, shape_b, b.pose);
        return found ? std::optional(answer_of_separation(*found->manifold)) : std::nullopt;
      }
      default:
        return motions_.answer(question, a, b);
    }
  }

 private:
  static std::optional<CaseAnswer> contacts(const FclShape& shape_a, const Pose& pose_a,
                                            const FclShape& shape_b, const Pose& pose_b) {
    const auto found = compare::find_contacts(shape_a, pose_a, shape_b, pose_b);
    if (!found) return std::nullopt;
    CaseAnswer answer;
    answer.manifold.emplace();
    for (const FclContact& c : *found)
      add_contact(c.point, c.normal, c.depth, *answer.manifold);
    return answer;
  }

  std::vector<FclShape> shapes_;
  FclMotions motions_;
};

class FclEngine : public Engine {
 public:
  CaseWitness name() const override { return {"fcl", fcl_version()}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<FclPair>(mesh_a, mesh_b);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<FclShapes>(shapes);
  }
};

}  // namespace

std::unique_ptr<Engine> make_fcl_engine() {
  return std::make_unique<FclEngine>();
}

}  // namespace graze::compare
