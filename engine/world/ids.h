#pragma once

// The ids that a world and a broad phase hand out for bodies and boxes: small values without any
// geometry.

#include <graze/bvh/box_pair.h>
#include <graze/bvh/hash.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace graze {

/// The id of a body of a World. An index is used again when its body is gone; the generation tells
/// the bodies of one index apart. Its highest 8 bits are the number of the world, if that has one
/// (WorldSettings::number), so that an id of another world is refused.
struct BodyId {
  std::uint32_t index = 0xffffffffu;  ///< a small number, which may serve as index of an array; of
                                      ///< no body as it is here
  std::uint32_t generation = 0;       ///< tells those apart that had the same index
  friend auto operator<=>(const BodyId&, const BodyId&) = default;
};

/// The ids of two bodies, the smaller index first.
struct BodyPair {
  BodyId a;  ///< the body with the smaller index
  BodyId b;  ///< the body with the larger index
  friend auto operator<=>(const BodyPair&, const BodyPair&) = default;
};

/// The id of a box of a BroadPhase. Indices are small numbers that are used again when a box is
/// gone; the generation tells the boxes of one index apart.
struct BoxId {
  std::uint32_t index = 0xffffffffu;  ///< a small number, which may serve as index of an array; of
                                      ///< no box as it is here
  std::uint32_t generation = 0;       ///< tells those apart that had the same index
  friend auto operator<=>(const BoxId&, const BoxId&) = default;
};

}  // namespace graze

template <>
struct std::hash<graze::BodyId> {
  std::size_t operator()(const graze::BodyId& id) const noexcept {
    return graze::hash_of({id.index, id.generation});
  }
};

template <>
struct std::hash<graze::BodyPair> {
  std::size_t operator()(const graze::BodyPair& pair) const noexcept {
    return graze::hash_of({pair.a.index, pair.a.generation, pair.b.index, pair.b.generation});
  }
};

template <>
struct std::hash<graze::BoxId> {
  std::size_t operator()(const graze::BoxId& id) const noexcept {
    return graze::hash_of({id.index, id.generation});
  }
};
