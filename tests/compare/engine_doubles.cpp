#include "tests/compare/engine_doubles.h"

#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_triangle.h>

namespace graze::compare {
namespace {

class WrongSignPair : public LoadedPair {
 public:
  explicit WrongSignPair(std::unique_ptr<LoadedPair> inner) : inner_(std::move(inner)) {}
  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    Pose wrong = pose_b;
    wrong.translation().x() = -wrong.translation().x();
    return inner_->answer(question, pose_a, wrong);
  }

 private:
  std::unique_ptr<LoadedPair> inner_;
};

class WrongSignShapes : public LoadedShapes {
 public:
  explicit WrongSignShapes(std::unique_ptr<LoadedShapes> inner) : inner_(std::move(inner)) {}
  std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a, std::size_t shape_b,
                                 const Pose& pose_b) const override {
    Pose wrong = pose_b;
    wrong.translation().x() = -wrong.translation().x();
    return inner_->intersects(shape_a, pose_a, shape_b, wrong);
  }

 private:
  std::unique_ptr<LoadedShapes> inner_;
};

class WrongSignEngine : public Engine {
 public:
  explicit WrongSignEngine(std::string name) : name_(std::move(name)) {}
  CaseWitness name() const override { return {name_, "planted"}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<WrongSignPair>(make_graze_engine()->load(mesh_a, mesh_b));
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<WrongSignShapes>(make_graze_engine()->load_shapes(shapes));
  }

 private:
  std::string name_;
};

class InwardPair : public LoadedPair {
 public:
  InwardPair(const Mesh& mesh_a, const Mesh& mesh_b, double margin)
      : mesh_a_(mesh_a), mesh_b_(mesh_b), margin_(margin) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    CaseAnswer answer;
    answer.pairs.emplace();
    for (std::uint32_t i = 0; i < mesh_a_.triangles().size(); ++i) {
      const Triangle a = place(pose_a, mesh_a_.triangle(i));
      for (std::uint32_t j = 0; j < mesh_b_.triangles().size(); ++j) {
        const Triangle b = place(pose_b, mesh_b_.triangle(j));
        if (may_meet(a, b) && intersects(a, b)) answer.pairs->push_back({i, j});
      }
    }
    if (question.ask == Ask::Pairs) return answer;
    if (question.ask != Ask::Any) return std::nullopt;
    answer.says = !answer.pairs->empty();
    answer.pairs.reset();
    return answer;
  }

 private:
  bool may_meet(const Triangle& a, const Triangle& b) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double max_a = std::max({a.a[axis], a.b[axis], a.c[axis]});
      const double min_a = std::min({a.a[axis], a.b[axis], a.c[axis]});
      const double max_b = std::max({b.a[axis], b.b[axis], b.c[axis]});
      const double min_b = std::min({b.a[axis], b.b[axis], b.c[axis]});
      if (max_a - min_b < margin_ || max_b - min_a < margin_) return false;
    }
    return true;
  }

  Mesh mesh_a_;
  Mesh mesh_b_;
  double margin_;
};

class InwardEngine : public Engine {
 public:
  InwardEngine(std::string name, double margin) : name_(std::move(name)), margin_(margin) {}
  CaseWitness name() const override { return {name_, "planted"}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<InwardPair>(mesh_a, mesh_b, margin_);
  }

 private:
  std::string name_;
  double margin_;
};

}  // namespace

std::unique_ptr<Engine> make_wrong_sign_engine(const std::string& name) {
  return std::make_unique<WrongSignEngine>(name);
}

std::unique_ptr<Engine> make_inward_rounding_engine(const std::string& name, double margin) {
  return std::make_unique<InwardEngine>(name, margin);
}

}  // namespace graze::compare
