#pragma once

#include <optional>
#include <string>
#include <vector>

#include <graze/bvh/pose.h>
#include <graze/engine/compare/judge/classics/classic_test.h>

namespace graze::compare {

/// Where corners are placed before they are tested.
enum class ClassicFrame {
  Common,  ///< both by their poses
  OfA,     ///< B's into A's frame, by one pose made of two; A's stay as they are
  Corner,  ///< likewise, and then all from A's first corner
};

/// Two triangles and their poses.
struct PosedTriangles {
  Triangle a;
  Pose pose_a;
  Triangle b;
  Pose pose_b;
};

/// The corners as they are placed in these numbers.
struct PlacedTriangles {
  Triangle a;
  Triangle b;
};
PlacedTriangles placed_in(const PosedTriangles& posed, ClassicFrame frame, ClassicNumbers numbers);

/// What happens from the corners to an answer, in one frame and one kind of numbers.
struct ClassicVariant {
  ClassicFrame frame;
  ClassicNumbers numbers;
  bool placed_touch = false;  ///< exactly, of the corners as they are placed
  double moved = 0;           ///< metres that placing has moved a corner at most
  ClassicRun axes;
  ClassicRun determinants;
};

/// All of them, those in double first.
std::vector<ClassicVariant> classic_variants(const PosedTriangles& posed);

/// Why textbook steps give the answer `says` about two triangles of which it is wrong, in words;
/// none if none of them does.
std::optional<std::string> blame(const std::vector<ClassicVariant>& variants, bool says);

const char* name_of(ClassicFrame frame);
const char* name_of(ClassicNumbers numbers);

}  // namespace graze::compare
