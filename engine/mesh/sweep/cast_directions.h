#pragma once

#include <graze/bvh/sphere.h>
#include <graze/bvh/value/float_box.h>
#include <graze/engine/mesh/sweep/framed_mesh.h>
#include <graze/engine/mesh/sweep/sweep.h>
#include <graze/narrowphase/lanes/two_lanes.h>

#include <span>

namespace graze::contacts {

/// Bounds from below how far B goes along d until it meets A, by six vectors for all boxes and
/// triangles: d, four across it, which tell whether things are in each other's way at all, and the
/// normal of the best contact so far, around which both surfaces are thin. What something is along
/// them is found once; to compare two takes some thirty operations, two vectors at a time.
class CastDirections {
 public:
  enum class Side { A, B };
  static constexpr int kPairs = 3;

  /// What something is along each vector, relative to the centre of its mesh's tree.
  struct Span {
    narrowphase::TwoLanes middle[kPairs];
    narrowphase::TwoLanes half[kPairs];
  };

  /// Of a direction whose largest component is from 1/2 to 1 in size, or of none.
  CastDirections(const FramedMesh& a, const FramedMesh& b, const SweepUnits& units,
                 const double (&direction)[3]);
  /// Of a mesh and a box in the frame of the mesh.
  CastDirections(const FramedMesh& a, const Aabb& b, const SweepUnits& units,
                 const double (&direction)[3]);

  /// Of a mesh and a ball.
  CastDirections(const FramedMesh& a, const Sphere& b, const SweepUnits& units,
                 const double (&direction)[3]);

  Span of_box(Side side, const bvh::FloatBox& box) const;
  Span of_points(Side side, std::span<const Eigen::Vector3d* const> points) const;
  Span of_triangle(Side side, const Triangle& placed) const {
    const Eigen::Vector3d* const corners[3] = {&placed.a, &placed.b, &placed.c};
    return of_points(side, corners);
  }
  /// Of the ball that this was made for.
  Span of_ball(const Sphere& ball) const;
  /// Of two things of one mesh together.
  static Span around(const Span& s, const Span& t);

  /// No more than the least s >= 0 at which something in `a` meets something in `b` moved by s d;
  /// infinite if there is none, or none up to `limit`.
  double first_contact(const Span& a, const Span& b, double limit) const;

  /// Takes another normal, in metres or whatever; spans that were made before serve no more. False,
  /// and nothing happens, if it is nearly the one that there is.
  bool take_normal(const double (&normal)[3]);

 private:
  /// A tree's frame, placed, in the units of the sweep.
  struct Frame {
    Frame(const FramedMesh& mesh, const SweepUnits& units);
    Frame(const Aabb& box, const SweepUnits& units);
    Frame(const Sphere& ball, const SweepUnits& units);

    double centre[3];
    double axis[3][3];
    double unit;
    double margin;
  };
  /// What two vectors make of three coordinates.
  struct Rows {
    narrowphase::TwoLanes x[kPairs];
    narrowphase::TwoLanes y[kPairs];
    narrowphase::TwoLanes z[kPairs];
  };
  struct Limits {
    narrowphase::TwoLanes between[kPairs];  ///< n . (the centre of A - the centre of B)
    narrowphase::TwoLanes margin[kPairs];
    narrowphase::TwoLanes least_high[kPairs];  ///< less, and they never meet
    narrowphase::TwoLanes most_low[kPairs];    ///< more, and they never meet
    narrowphase::TwoLanes down[kPairs];  ///< what `low` is multiplied by to bound s from below
  };

  const Frame& frame(Side side) const { return side == Side::A ? a_ : b_; }
  CastDirections(const Frame& a, const Frame& b, const SweepUnits& units,
                 const double (&direction)[3]);
  void set(int at, const double (&n)[3]);

  double per_metre_;
  Frame a_;
  Frame b_;
  double direction_[3];
  double normal_[3] = {0, 0, 0};
  Rows vectors_;  ///< of coordinates in the units of the sweep
  Rows local_a_;  ///< of local coordinates of A's tree
  Rows local_b_;
  Limits limits_;
};

}  // namespace graze::contacts
