#pragma once

// Holds the units of a scene's file. Private to engine/scenes.

#include <graze/engine/cases/text/json_cursor.h>
#include <Eigen/Core>

namespace graze::scenes {

/// A metre has `per_metre` of it, or it has `metres`: one of the two is 1, so that a length that is
/// a double in both units is converted with one rounding at most.
struct LengthUnit {
  const char* name;
  double metres;
  double per_metre;

  double to_metres(double length) const { return length * metres / per_metre; }
};

struct AngleUnit {
  const char* name;
  double per_turn;

  double to_turns(double angle) const { return angle / per_turn; }
};

LengthUnit read_length_unit(const cases::JsonCursor& at);
AngleUnit read_angle_unit(const cases::JsonCursor& at);

/// Says how the lengths and angles of a file are meant.
struct SceneUnits {
  LengthUnit length{"m", 1, 1};
  AngleUnit angle{"degree", 360};

  double read_length(const cases::JsonCursor& at) const;
  Eigen::Vector3d read_point(const cases::JsonCursor& at) const;
};

}  // namespace graze::scenes
