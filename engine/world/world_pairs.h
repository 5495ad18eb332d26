#pragma once

#include <graze/bvh/hash.h>
#include <graze/bvh/pose.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/ids.h>
#include <graze/engine/world/shape_pairs.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace graze {

class World;

/// A world in a pose, for questions that another world is asked, such as a robot's world in the
/// frame of its cell's world. It refers to the world, which must outlive it.
struct PlacedWorldView {
  const World& world;            ///< must outlive this
  Pose pose = Pose::Identity();  ///< the pose that takes points of this world to the one that is
                                 ///< asked
};

/// Says which pairs of bodies a query is about.
struct WorldPairSettings {
  bool has_filters = true;        ///< if true, only pairs that may meet as the query says; else all
  std::optional<Role> role = {};  ///< if set, only pairs of solid bodies, or only pairs of sensors;
                                  ///< else all
};

/// A body of the world that was asked, and one of the other.
struct WorldBodyPair {
  BodyId a;  ///< the body of the world that was asked
  BodyId b;  ///< the body of the other one
  friend auto operator<=>(const WorldBodyPair&, const WorldBodyPair&) = default;
};

/// The distance of two bodies.
struct BodyPairDistance {
  BodyId a;                  ///< the body of the world that was asked
  BodyId b;                  ///< the body of the other world, or another body of the same one
  ShapeDistance distance;    ///< the distance from A to B, in the frame of the world that was asked
  std::uint32_t part_a = 0;  ///< if A is a Compound, its nearest part, the first of equals
  std::uint32_t part_b = 0;  ///< if B is a Compound, its nearest part, the first of equals

  bool operator==(const BodyPairDistance&) const = default;
};

}  // namespace graze

template <>
struct std::hash<graze::WorldBodyPair> {
  std::size_t operator()(const graze::WorldBodyPair& pair) const noexcept {
    return graze::hash_of({pair.a.index, pair.a.generation, pair.b.index, pair.b.generation});
  }
};
