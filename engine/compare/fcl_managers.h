#pragma once

// Asks FCL's broad phases, its managers of many bodies. No type of FCL appears here.

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

namespace graze::compare {

/// Says how FCL finds those of many bodies whose boxes meet.
enum class FclManager { Tree, TreeArray, Sap, Ssap, IntervalTree, SpatialHash, Naive };

inline constexpr std::array kFclManagers = {
    FclManager::Tree,         FclManager::TreeArray,   FclManager::Sap,  FclManager::Ssap,
    FclManager::IntervalTree, FclManager::SpatialHash, FclManager::Naive};

/// Returns what the engine is called: "fcl-tree", "fcl-sap".
const char* name_of(FclManager manager);

/// Holds a body of a scene: one of its shapes, in a pose.
struct FclBody {
  std::size_t shape = 0;  ///< the shape's index
  Pose pose = Pose::Identity();
};

/// Holds the shapes of a scene as FCL has them, and asks about bodies of these shapes. One thread
/// may use it at a time.
class FclScene {
 public:
  FclScene(std::span<const Shape> shapes, FclManager manager);
  ~FclScene();

  /// True if FCL knows how to collide two of these shapes, by their indices, and the manager takes
  /// both: a tree of FCL 0.7 takes no half-spaces and planes.
  bool knows(std::size_t shape_a, std::size_t shape_b) const;

  /// Returns the pairs of bodies that FCL says collide, by their indices, the smaller one first,
  /// ascending. It puts all bodies into a new manager, whose one walk over all of them names pairs
  /// of boxes that meet, about which it asks FCL's collide(). It asks nothing about pairs whose
  /// shapes FCL does not know.
  std::vector<std::pair<std::size_t, std::size_t>> colliding(std::span<const FclBody> bodies) const;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace graze::compare
