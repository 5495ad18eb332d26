#include "tests/compare/engine_doubles.h"

#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <limits>
#include <stdexcept>
#include <utility>

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

class SenselessPair : public LoadedPair {
 public:
  SenselessPair(std::unique_ptr<LoadedPair> inner, NoAnswer kind)
      : inner_(std::move(inner)), kind_(kind) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    if (kind_ == NoAnswer::Throw) throw std::runtime_error("out of its depth");
    CaseAnswer answer = *inner_->answer(question, pose_a, pose_b);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector3d point(nan, 0, 0);
    const CaseContact nowhere = {point, point, point, point, 0};
    if (kind_ == NoAnswer::AnotherPart) {
      answer = {};
      answer.translation = Eigen::Vector3d(0, 0, 0);
    } else if (kind_ == NoAnswer::NotANumber) {
      if (answer.distance) answer.distance = nan;
      if (answer.contacts) answer.contacts->assign(1, nowhere);
    } else if (kind_ == NoAnswer::StrangeTriangle) {
      if (answer.pairs) answer.pairs->push_back({0, 4294967295U});
      if (answer.pair) answer.pair->b = 4294967295U;
    } else if (answer.pairs) {
      answer.pairs->insert(answer.pairs->end(), 2, TrianglePair{0, 0});
    }
    return answer;
  }

 private:
  std::unique_ptr<LoadedPair> inner_;
  NoAnswer kind_;
};

class SenselessEngine : public Engine {
 public:
  SenselessEngine(std::string name, NoAnswer kind) : name_(std::move(name)), kind_(kind) {}
  CaseWitness name() const override { return {name_, "planted"}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<SenselessPair>(make_graze_engine()->load(mesh_a, mesh_b), kind_);
  }

 private:
  std::string name_;
  NoAnswer kind_;
};

class WatchedPair : public LoadedPair {
 public:
  WatchedPair(std::unique_ptr<LoadedPair> inner, const std::function<void()>& on_question)
      : inner_(std::move(inner)), on_question_(on_question) {}
  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    on_question_();
    return inner_->answer(question, pose_a, pose_b);
  }

 private:
  std::unique_ptr<LoadedPair> inner_;
  const std::function<void()>& on_question_;
};

class WatchedEngine : public Engine {
 public:
  WatchedEngine(std::string name, std::function<void()> on_question)
      : name_(std::move(name)), on_question_(std::move(on_question)) {}
  CaseWitness name() const override { return {name_, "watched"}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<WatchedPair>(make_graze_engine()->load(mesh_a, mesh_b), on_question_);
  }

 private:
  std::string name_;
  std::function<void()> on_question_;
};

class MotionlessPair : public LoadedPair {
 public:
  MotionlessPair(const Mesh& mesh_a, const Mesh& mesh_b)
      : pair_(make_graze_engine()->load(mesh_a, mesh_b)) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    return pair_->answer({question.ask, question.settings}, pose_a, pose_b);
  }

 private:
  std::unique_ptr<LoadedPair> pair_;
};

class MotionlessShapes : public LoadedShapes {
 public:
  explicit MotionlessShapes(std::span<const Shape> shapes)
      : shapes_(make_graze_engine()->load_shapes(shapes)) {}

  std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a, std::size_t shape_b,
                                 const Pose& pose_b) const override {
    return shapes_->intersects(shape_a, pose_a, shape_b, pose_b);
  }
  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& a,
                                   const PlacedShape& b) const override {
    return shapes_->answer({question.ask, question.settings}, a, b);
  }

 private:
  std::unique_ptr<LoadedShapes> shapes_;
};

class MotionlessEngine : public Engine {
 public:
  explicit MotionlessEngine(std::string name) : name_(std::move(name)) {}
  CaseWitness name() const override { return {name_, ""}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<MotionlessPair>(mesh_a, mesh_b);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<MotionlessShapes>(shapes);
  }

 private:
  std::string name_;
};

/// Answers as graze does, but for its distances.
class OffEngine : public Engine {
 public:
  OffEngine(std::string name, double error) : name_(std::move(name)), error_(error) {}
  CaseWitness name() const override { return {name_, "planted"}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    class OffPair : public LoadedPair {
     public:
      OffPair(std::unique_ptr<LoadedPair> inner, double error)
          : inner_(std::move(inner)), error_(error) {}
      std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                       const Pose& pose_b) const override {
        std::optional<CaseAnswer> answer = inner_->answer(question, pose_a, pose_b);
        if (answer && answer->distance) *answer->distance += error_;
        return answer;
      }

     private:
      std::unique_ptr<LoadedPair> inner_;
      double error_;
    };
    return std::make_unique<OffPair>(make_graze_engine()->load(mesh_a, mesh_b), error_);
  }

 private:
  std::string name_;
  double error_;
};

}  // namespace

std::unique_ptr<Engine> make_off_engine(const std::string& name, double error) {
  return std::make_unique<OffEngine>(name, error);
}

std::unique_ptr<Engine> make_senseless_engine(const std::string& name, NoAnswer kind) {
  return std::make_unique<SenselessEngine>(name, kind);
}

std::unique_ptr<Engine> make_watched_engine(const std::string& name,
                                            std::function<void()> on_question) {
  return std::make_unique<WatchedEngine>(name, std::move(on_question));
}

std::unique_ptr<Engine> make_motionless_engine(const std::string& name) {
  return std::make_unique<MotionlessEngine>(name);
}

std::unique_ptr<Engine> make_wrong_sign_engine(const std::string& name) {
  return std::make_unique<WrongSignEngine>(name);
}

std::unique_ptr<Engine> make_inward_rounding_engine(const std::string& name, double margin) {
  return std::make_unique<InwardEngine>(name, margin);
}

}  // namespace graze::compare
