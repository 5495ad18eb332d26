#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/scenes/scene.h>

namespace graze::compare {

/// Names pairs of bodies, by their indices.
using IndexPairs = std::span<const std::pair<std::size_t, std::size_t>>;

/// This is an engine that holds the shapes of a scene and, for confirming what it said, a few pairs
/// of them by themselves, or all again if it looks for pairs itself. The entry must outlive this.
class SceneEngine {
 public:
  SceneEngine(const EngineEntry& entry, std::span<const Shape> shapes,
              std::unique_ptr<LoadedShapes> loaded)
      : entry_(&entry), shapes_(shapes.begin(), shapes.end()), loaded_(std::move(loaded)) {}

  const EngineEntry& entry() const { return *entry_; }
  const LoadedShapes& loaded() const { return *loaded_; }

  /// Returns what it says of one of the pairs where nothing else was asked before.
  Utterance hear_alone(std::span<const PlacedShape> bodies, IndexPairs pairs,
                       std::size_t place) const;

  /// Returns what it answers to any other question about two bodies, and how long that took.
  Utterance hear(const Question& question, const PlacedShape& a, const PlacedShape& b) const;
  /// Returns the same where nothing else was asked before.
  Utterance hear_alone(const Question& question, const PlacedShape& a, const PlacedShape& b) const;

 private:
  struct Alone {
    std::mutex mutex;
    std::map<std::pair<std::size_t, std::size_t>, std::shared_ptr<LoadedShapes>> pairs;
    std::shared_ptr<LoadedShapes> scene;
  };

  std::optional<bool> says_of_two(const PlacedShape& a, const PlacedShape& b) const;
  std::optional<bool> says_of_all(std::span<const PlacedShape> bodies, IndexPairs pairs,
                                  std::size_t place) const;
  std::shared_ptr<LoadedShapes> load_all_alone() const;
  std::shared_ptr<LoadedShapes> load_alone(std::size_t shape_a, std::size_t shape_b) const;

  const EngineEntry* entry_;
  std::vector<Shape> shapes_;
  std::unique_ptr<LoadedShapes> loaded_;
  std::unique_ptr<Alone> alone_ = std::make_unique<Alone>();
};

/// Returns every engine that is here, takes shapes, and may know the question. Throws
/// UnsupportedPairError, which names the body, for a body that has parts: other engines are asked
/// about single shapes.
std::vector<SceneEngine> load_scene(const Scene& scene, std::span<const EngineEntry> engines,
                                    Ask ask);

}  // namespace graze::compare
