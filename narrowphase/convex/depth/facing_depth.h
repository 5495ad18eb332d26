#pragma once

// Finds how far a convex set reaches beyond an edge or a corner of a surface, along the directions
// that the edge or the corner faces. By such depths a body leaves a mesh where it touches it.

#include <graze/narrowphase/convex/core/core.h>

#include <cstddef>
#include <limits>
#include <optional>

namespace graze::narrowphase {

/// A way out: moving a set by `depth` along `direction` takes it off a feature.
struct Exit {
  Vec3 direction;    ///< unit, in which the set moves
  double depth = 0;  ///< metres
};

/// Directions at right angles to an edge: cos(t) first + sin(t) aside for t from 0 to an angle of
/// at most pi. Angles are cosines and sines, which are equal on all machines; what libraries make
/// of an angle need not be.
struct DirectionArc {
  Vec3 first;         ///< unit
  Vec3 aside;         ///< unit, at right angles to the first
  double cosine = 1;  ///< the cosine of the angle
  double sine = 0;
};

/// Returns the least depth by which the set reaches beyond the line of an edge along any direction
/// of the arc; `corner` is a point of the edge. It is off by at most kFacingTolerance of the set's
/// size, unless kMostSupports are spent.
///
/// Each support point bounds the depth from below, all along the arc, by a sinusoid. An interval is
/// halved where the sinusoids of its ends bound it least, the lowest bound first; of a polygon this
/// visits the corners alone.
///
/// `deepest` is the core's support point against the arc's first direction. Where bounds show that
/// no depth is below the limit the search ends, with one that is not.
Exit least_on_arc(const Core& core, const Vec3& corner, const DirectionArc& arc,
                  const Vec3& deepest, double limit = std::numeric_limits<double>::infinity());

inline constexpr double kFacingTolerance = 1e-7;
inline constexpr int kMostSupports = 48;

/// Lists ways in which a set leaves a corner: the shortest through each smooth part of its surface.
class CornerExits {
 public:
  CornerExits(const Core& core, const Vec3& corner);

  /// Returns the next exit whose depth is below `limit`, in no order, and nothing if there are no
  /// more. Exits in a direction that the corner does not face are of no use. A hull has one exit
  /// for each face, an ellipsoid one, a box six; a set with a radius has one more, over its edges.
  std::optional<Exit> next(double limit);

 private:
  std::optional<Exit> next_part();
  bool is_rounded() const;
  std::optional<Exit> of_nearest() const;
  Exit exit(const Vec3& outward, double depth) const;
  std::optional<Exit> of_rounded();
  Exit of_box();
  Exit of_cylinder();
  Exit of_cone();

  const Core& core_;
  const Vec3& corner_;
  Vec3 own_;  ///< the corner in the core's frame
  std::size_t part_ = 0;
  std::size_t parts_ = 0;
  bool is_last_asked_ = false;
};

}  // namespace graze::narrowphase
