#pragma once

// What may happen to a world, as data: so that it can be drawn from a seed, shrunk and kept.

#include <graze/bvh/pose.h>
#include <graze/bvh/ray.h>
#include <graze/engine/world/shape.h>
#include <graze/engine/world/world.h>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace graze::tests {

enum class Verb {
  Add,
  Remove,
  Move,
  MoveToo,  // in one call with the Move before
  SetShape,
  SetFilter,
  SetMotion,
  SetRole,
  Sleep,
  Wake,
  Exclude,
  Include,
  FilterPairs,  // bodies a and b meet unless (a + b) % number is 0; all do for 0
  Update,
  Save,
  Restore,  // what was saved last
  AskTouching,
  AskWithin,
  AskClosest,
  AskRay,
  AskBox,
  // Of bodies of parts; on others they are passed over. `part` counts among the parts that there
  // are, in a circle.
  AddPart,
  ReplacePart,
  MovePart,
  RemovePart,
  SetPart,
  FillVoxels,
  ClearVoxels,
  AskClosestPair,
  // Of what lies between bodies, and between updates.
  SetMargin,
  SetDetection,
  AskCast  // a shape from a pose to another, the short way
};

/// What a verb does not need keeps its default.
struct Operation {
  Verb verb = Verb::Update;
  std::uint32_t body = 0;    // a name: given by its Add, never used again
  std::uint32_t number = 0;  // the other body, the shape in the palette, a divisor, a label
  std::uint32_t part = 0;
  bool has_filter = false;  // a part of its own
  BodySettings settings = {};
  Pose pose = Pose::Identity();
  Pose end = Pose::Identity();        // of a cast
  std::array<double, 7> values = {};  // clearance or margin; ray: origin, direction, end; box: min,
                                      // max
  std::array<std::uint16_t, 6> voxels = {};  // the first and the last, both included
};

/// Where bodies are, and how large: each has a palette of shapes of its own.
enum class Setting {
  Crowd,    // sizes about 1, turned at random
  Lattice,  // whole coordinates and right angles, some an ulp off: touching, coincident, just apart
  Sizes,    // from 1e-6 to 1e6
  Far,      // sizes about 1 at 1e7 from the origin
  OnePoint,   // all in one place, some an ulp off
  Skewed,     // turned by matrices that are as far from rotations as the door lets in
  Teleports,  // between places that are 1e9 apart
  Terrains,   // sizes about 1, with height fields and planes of two sides, and margins, casts and
              // bodies that are swept
  Parts       // likewise with compounds and maps of voxels whose parts change
};
inline constexpr std::array kSettings{Setting::Crowd,     Setting::Lattice,  Setting::Sizes,
                                      Setting::Far,       Setting::OnePoint, Setting::Skewed,
                                      Setting::Teleports, Setting::Terrains, Setting::Parts};
const char* name_of(Setting setting);

/// Shapes of every kind, made without the C library's sine: the same on every machine.
std::vector<Shape> palette_of(Setting setting);

struct History {
  Setting setting = Setting::Crowd;
  std::vector<Operation> operations;
};

/// So many operations, the same for the same seed.
History random_history(Setting setting, std::uint64_t seed, std::size_t count);

/// As lines of text: hex floats, which lose nothing. read_history() throws std::runtime_error that
/// names the line.
void write_history(const History& history, std::ostream& out);
History read_history(std::istream& in);
std::string to_text(const Operation& operation);

}  // namespace graze::tests
