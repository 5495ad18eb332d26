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

/// A world in a pose, to be asked about by another one: a robot's in the frame of its cell's. It
/// refers to the world, which must outlive it.
struct PlacedWorldView {
  const World& world;            ///< must outlive this
  Pose pose = Pose::Identity();  ///< takes points of this world to the one that is asked
};

/// Which pairs of bodies a query is about.
struct WorldPairSettings {
  bool has_filters = true;        ///< only pairs that may meet as the query says; else all
  std::optional<Role> role = {};  ///< only pairs of solid bodies, or of sensors; else all
};

/// A body of the world that was asked, and one of the other.
struct WorldBodyPair {
  BodyId a;  ///< of the world that was asked
  BodyId b;  ///< of the other one
  friend auto operator<=>(const WorldBodyPair&, const WorldBodyPair&) = default;
};

/// How far two bodies are apart.
struct BodyPairDistance {
  BodyId a;                  ///< of the world that was asked
  BodyId b;                  ///< of the other one, where there are two worlds
  ShapeDistance distance;    ///< from A to B, in the frame of the world that was asked
  std::uint32_t part_a = 0;  ///< where A is a Compound: its nearest part, of equals the first
  std::uint32_t part_b = 0;  ///< where B is one, likewise

  bool operator==(const BodyPairDistance&) const = default;
};

}  // namespace graze

template <>
struct std::hash<graze::WorldBodyPair> {
  std::size_t operator()(const graze::WorldBodyPair& pair) const noexcept {
    return graze::hash_of({pair.a.index, pair.a.generation, pair.b.index, pair.b.generation});
  }
};
