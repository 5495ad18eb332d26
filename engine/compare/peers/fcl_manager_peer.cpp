// Asks FCL's broad phases, an engine each: all pairs of a scene's step are one question, for the
// walk over all bodies is on trial.

#include <graze/engine/compare/fcl_engine.h>
#include <graze/engine/compare/fcl_managers.h>
#include <graze/engine/compare/peers/adaptors.h>

#include <algorithm>
#include <array>

namespace graze::compare {
namespace {

class FclManagedShapes : public LoadedShapes {
 public:
  FclManagedShapes(std::span<const Shape> shapes, FclManager manager) : scene_(shapes, manager) {}

  std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a, std::size_t shape_b,
                                 const Pose& pose_b) const override {
    const std::array<PlacedShape, 2> bodies = {{{shape_a, pose_a}, {shape_b, pose_b}}};
    const std::array<std::pair<std::size_t, std::size_t>, 1> pairs = {{{0, 1}}};
    return intersect_all(bodies, pairs).pairs.front().says;
  }

  ShapesAnswer intersect_all(
      std::span<const PlacedShape> bodies,
      std::span<const std::pair<std::size_t, std::size_t>> pairs) const override {
    std::vector<FclBody> placed;
    placed.reserve(bodies.size());
    for (const PlacedShape& body : bodies)
      placed.push_back({body.shape, body.pose});
    ShapesAnswer all;
    const auto start = std::chrono::steady_clock::now();
    const std::vector<std::pair<std::size_t, std::size_t>> found = scene_.colliding(placed);
    all.time = std::chrono::steady_clock::now() - start;
    all.pairs.reserve(pairs.size());
    for (const auto& [a, b] : pairs) {
      ShapesAnswer::Pair& pair = all.pairs.emplace_back();
      if (!scene_.knows(bodies[a].shape, bodies[b].shape)) continue;
      const std::pair<std::size_t, std::size_t> asked = std::minmax(a, b);
      pair.says = std::binary_search(found.begin(), found.end(), asked);
    }
    return all;
  }

 private:
  FclScene scene_;
};

/// Makes two meshes a scene of two bodies.
class FclManagedPair : public LoadedPair {
 public:
  FclManagedPair(const Mesh& mesh_a, const Mesh& mesh_b, FclManager manager)
      : shapes_(std::array{Shape(mesh_a), Shape(mesh_b)}, manager) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    if (question.ask != Ask::Any || !question.is_plain()) return std::nullopt;
    CaseAnswer answer;
    answer.says = shapes_.intersects(0, pose_a, 1, pose_b);
    return answer;
  }

 private:
  FclManagedShapes shapes_;
};

class FclManagerEngine : public Engine {
 public:
  explicit FclManagerEngine(FclManager manager) : manager_(manager) {}

  CaseWitness name() const override { return {name_of(manager_), fcl_version()}; }
  std::optional<std::vector<Ask>> questions() const override { return {{Ask::Any}}; }
  bool answers_scenes() const override { return true; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<FclManagedPair>(mesh_a, mesh_b, manager_);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<FclManagedShapes>(shapes, manager_);
  }

 private:
  FclManager manager_;
};

}  // namespace

std::unique_ptr<Engine> make_fcl_manager_engine(const std::string& name) {
  for (const FclManager manager : kFclManagers)
    if (name == name_of(manager)) return std::make_unique<FclManagerEngine>(manager);
  return nullptr;
}

}  // namespace graze::compare
