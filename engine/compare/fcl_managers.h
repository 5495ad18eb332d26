#pragma once

// FCL's broad phases: its managers of many bodies. No type of FCL appears here.

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

namespace graze::compare {

/// How FCL finds those of many bodies whose boxes meet.
enum class FclManager { Tree, TreeArray, Sap, Ssap, IntervalTree, SpatialHash, Naive };

inline constexpr std::array kFclManagers = {
    FclManager::Tree,         FclManager::TreeArray,   FclManager::Sap,  FclManager::Ssap,
    FclManager::IntervalTree, FclManager::SpatialHash, FclManager::Naive};

/// "fcl-tree", "fcl-sap": what the engine is called.
const char* name_of(FclManager manager);

/// A body of a scene: one of its shapes, in a pose.
struct FclBody {
  std::size_t shape = 0;  ///< its index
  Pose pose = Pose::Identity();
};

/// The shapes of a scene as FCL has them, and how bodies of these shapes are asked about. One
/// thread at a time.
class FclScene {
 public:
  FclScene(std::span<const Shape> shapes, FclManager manager);
  ~FclScene();

  /// Whether FCL knows how to collide two of these shapes, by their indices, and the manager takes
  /// both: a tree of FCL 0.7 takes no half-spaces and planes.
  bool knows(std::size_t shape_a, std::size_t shape_b) const;

  /// All bodies are put into a new manager, whose one walk over all of them names pairs of boxes
  /// that meet, of which FCL's collide() is asked: those that it says collide, by their indices,
  /// the smaller one first, ascending. Of pairs whose shapes it does not know nothing is asked.
  std::vector<std::pair<std::size_t, std::size_t>> colliding(std::span<const FclBody> bodies) const;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace graze::compare
