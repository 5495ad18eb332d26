#pragma once

#include <optional>
#include <string>
#include <vector>

#include <graze/bvh/pose.h>
#include <graze/engine/compare/judge/classics/classic_test.h>

namespace graze::compare {

/// Says where corners are placed before they are tested.
enum class ClassicFrame {
  Common,  ///< both are placed by their poses
  OfA,     ///< B's are placed into A's frame, by one pose made of two; A's stay as they are
  Corner,  ///< as OfA, and then all are taken from A's first corner
};

/// Holds two triangles and their poses.
struct PosedTriangles {
  Triangle a;
  Pose pose_a;
  Triangle b;
  Pose pose_b;
};

/// Holds the corners as they are placed in these numbers.
struct PlacedTriangles {
  Triangle a;
  Triangle b;
};
PlacedTriangles placed_in(const PosedTriangles& posed, ClassicFrame frame, ClassicNumbers numbers);

/// Says what happens from the corners to an answer, in one frame and one kind of numbers.
struct ClassicVariant {
  ClassicFrame frame;
  ClassicNumbers numbers;
  bool placed_touch = false;  ///< true if the corners as they are placed touch, exactly
  double moved = 0;           ///< metres, the most that placing has moved a corner
  ClassicRun axes;
  ClassicRun determinants;
};

/// Returns all variants, those in double first.
std::vector<ClassicVariant> classic_variants(const PosedTriangles& posed);

/// Says in words why textbook steps give the wrong answer `says` about two triangles; nothing if
/// none of them does.
std::optional<std::string> blame(const std::vector<ClassicVariant>& variants, bool says);

const char* name_of(ClassicFrame frame);
const char* name_of(ClassicNumbers numbers);

}  // namespace graze::compare
