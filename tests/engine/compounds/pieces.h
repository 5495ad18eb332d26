#pragma once

// What two worlds, or one, say of pairs of bodies: every pair of parts asked by itself.

#include <graze/engine/world/world.h>

#include <optional>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::tests {

/// A part, or a body that has none, in the frame of the world that is asked.
struct Piece {
  BodyId body;
  std::uint32_t part;
  Shape shape;
  Pose pose;
  Filter filter;
  Role role;
  BodyKind kind;
};

std::vector<Piece> pieces_of(const World& world, const Pose& in);

/// Whether filters and roles let two of them be a pair of two worlds.
bool are_asked_for(const World& world_a, const Piece& a, const World& world_b, const Piece& b,
                   const WorldPairSettings& settings);

/// By distance, then by bodies and parts.
bool is_nearer(const BodyPairDistance& s, const BodyPairDistance& t);

/// What all pairs of pieces say.
struct Truth {
  std::vector<WorldBodyPair> touching;
  std::vector<BodyPairDistance> within;
  std::optional<BodyPairDistance> closest;
};

Truth truth_of(const World& a, const World& b, const Pose& pose, double clearance,
               const WorldPairSettings& settings);

Shape any_shape(RandomSource& source);

void expect_equal(const std::vector<BodyPairDistance>& found,
                  const std::vector<BodyPairDistance>& wanted);

}  // namespace graze::tests
