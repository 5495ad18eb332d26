#include <graze/bvh/error.h>
#include <graze/engine/compare/run/scene_engine.h>

#include <array>
#include <chrono>

namespace graze::compare {

Utterance SceneEngine::hear_alone(std::span<const PlacedShape> bodies, IndexPairs pairs,
                                  std::size_t place) const {
  return compare::hear(
      [&] {
        const std::optional<bool> says =
            entry_->engine->answers_scenes()
                ? says_of_all(bodies, pairs, place)
                : says_of_two(bodies[pairs[place].first], bodies[pairs[place].second]);
        std::optional<CaseAnswer> answer;
        if (says) answer.emplace().says = says;
        return TimedAnswer(std::move(answer));
      },
      entry_->name);
}

Utterance SceneEngine::hear(const Question& question, const PlacedShape& a,
                            const PlacedShape& b) const {
  return compare::hear(
      [&] {
        const auto start = std::chrono::steady_clock::now();
        std::optional<CaseAnswer> answer = loaded_->answer(question, a, b);
        return TimedAnswer(std::move(answer), std::chrono::steady_clock::now() - start);
      },
      entry_->name);
}

Utterance SceneEngine::hear_alone(const Question& question, const PlacedShape& a,
                                  const PlacedShape& b) const {
  return compare::hear(
      [&] {
        const std::shared_ptr<LoadedShapes> alone = load_alone(a.shape, b.shape);
        return TimedAnswer(alone ? alone->answer(question, {0, a.pose}, {1, b.pose})
                                 : loaded_->answer(question, a, b));
      },
      entry_->name);
}

std::optional<bool> SceneEngine::says_of_two(const PlacedShape& a, const PlacedShape& b) const {
  const std::shared_ptr<LoadedShapes> alone = load_alone(a.shape, b.shape);
  return alone ? alone->intersects(0, a.pose, 1, b.pose)
               : loaded_->intersects(a.shape, a.pose, b.shape, b.pose);
}

std::optional<bool> SceneEngine::says_of_all(std::span<const PlacedShape> bodies, IndexPairs pairs,
                                             std::size_t place) const {
  const std::shared_ptr<LoadedShapes> alone = load_all_alone();
  const ShapesAnswer all = (alone ? *alone : *loaded_).intersect_all(bodies, pairs);
  if (!all.pairs[place].fault.empty()) throw EngineFailure(all.pairs[place].fault);
  return all.pairs[place].says;
}

std::shared_ptr<LoadedShapes> SceneEngine::load_all_alone() const {
  const std::lock_guard lock(alone_->mutex);
  if (alone_->scene) return alone_->scene;
  const std::unique_ptr<Engine> engine = entry_->engine->alone();
  if (engine) alone_->scene = engine->load_shapes(shapes_);
  return alone_->scene;
}

/// Loads the shapes for confirming; null if the engine needs no such thing.
std::shared_ptr<LoadedShapes> SceneEngine::load_alone(std::size_t shape_a,
                                                      std::size_t shape_b) const {
  constexpr std::size_t kMostKept = 8;  // each of them is a process
  const std::lock_guard lock(alone_->mutex);
  const auto at = alone_->pairs.find({shape_a, shape_b});
  if (at != alone_->pairs.end()) return at->second;
  const std::unique_ptr<Engine> engine = entry_->engine->alone();
  if (!engine) return nullptr;
  const std::array<Shape, 2> shapes = {shapes_[shape_a], shapes_[shape_b]};
  if (alone_->pairs.size() == kMostKept) alone_->pairs.clear();
  return alone_->pairs[{shape_a, shape_b}] = engine->load_shapes(shapes);
}

std::vector<SceneEngine> load_scene(const Scene& scene, std::span<const EngineEntry> engines,
                                    Ask ask) {
  for (const SceneBody& body : scene.bodies) {
    if (body.parts.empty()) continue;
    throw UnsupportedPairError("body \"" + body.name +
                               "\" has parts: other engines are asked about single shapes");
  }
  std::vector<Shape> shapes;
  shapes.reserve(scene.shapes.size());
  for (const SceneShape& shape : scene.shapes)
    shapes.push_back(shape.shape);
  std::vector<SceneEngine> loaded;
  for (const EngineEntry& entry : engines) {
    if (entry.engine == nullptr) continue;
    if (ask != Ask::Any && entry.engine->answers_scenes()) continue;
    std::unique_ptr<LoadedShapes> its = entry.engine->load_shapes(shapes);
    if (its) loaded.emplace_back(entry, shapes, std::move(its));
  }
  return loaded;
}

}  // namespace graze::compare
