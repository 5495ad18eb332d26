#pragma once

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/skins/kdop_separation.h>
#include <graze/bvh/sphere.h>
#include <graze/engine/mesh/sweep/cast_planes.h>
#include <graze/narrowphase/lanes/two_lanes.h>

#include <algorithm>
#include <limits>
#include <span>

namespace graze::contacts {

/// Bounds from below how far a box or a ball, B, goes along d until it meets a mesh, A, by six
/// vectors for all nodes and triangles: four across d, which tell whether things are in each
/// other's way at all, d itself and the normal of the best contact so far, around which both
/// surfaces are thin. The spans of something along them are found once; to compare two takes a
/// dozen operations, two vectors at a time.
class CastDirections {
 public:
  using Side = CastPlanes::Side;
  static constexpr int kPairs = 3;

  /// The pairs of vectors that are meant: all, or the one with the normal, which alone
  /// take_normal() changes.
  enum class Pairs { All, WithNormal };

  /// The intervals of something along each vector, from where it begins to where it ends, relative
  /// to the centre of the tree of B; those of A have all margins.
  struct Span {
    narrowphase::TwoLanes low[kPairs];
    narrowphase::TwoLanes high[kPairs];
  };

  /// Chooses directions for a mesh and a box in the frame of the mesh, and a direction whose
  /// largest component is from 1/2 to 1 in size, or none.
  CastDirections(const FramedMesh& a, const Aabb& b, const SweepUnits& units,
                 const double (&direction)[3]);

  /// Chooses directions for a mesh and a ball.
  CastDirections(const FramedMesh& a, const Sphere& b, const SweepUnits& units,
                 const double (&direction)[3]);

  /// Measure the spans of a k-DOP of A's tree, of points and of a triangle along these vectors.
  void measure_kdop(const bvh::FloatKDop& kdop, Pairs pairs, Span& span) const;
  void measure_points(Side side, std::span<const Eigen::Vector3d* const> points, Pairs pairs,
                      Span& span) const;
  void measure_triangle(Side side, const Triangle& placed, Pairs pairs, Span& span) const {
    const Eigen::Vector3d* const corners[3] = {&placed.a, &placed.b, &placed.c};
    measure_points(side, corners, pairs, span);
  }
  Span of_points(Side side, std::span<const Eigen::Vector3d* const> points) const {
    Span span;
    measure_points(side, points, Pairs::All, span);
    return span;
  }
  Span of_triangle(Side side, const Triangle& placed) const {
    Span span;
    measure_triangle(side, placed, Pairs::All, span);
    return span;
  }
  /// Returns the span of the ball that this was made for.
  Span of_ball(const Sphere& ball) const;
  /// Returns the span of two things of one mesh together.
  static Span around(const Span& s, const Span& t);

  /// Returns no more than the least s >= 0 at which something in `a` meets something in `b` moved
  /// by s d. It is infinite if there is none, or none up to `limit`.
  double first_contact(const Span& a, const Span& b, double limit) const;

  /// Takes another normal, in metres or whatever; in spans that were made before, the pair with the
  /// normal serves no more. Returns false, and does nothing, if it is nearly the one that there is.
  bool take_normal(const double (&normal)[3]);

 private:
  using TwoLanes = narrowphase::TwoLanes;

  /// Two vectors in each row, for the products with three coordinates.
  struct Rows {
    narrowphase::TwoLanes x[kPairs];
    narrowphase::TwoLanes y[kPairs];
    narrowphase::TwoLanes z[kPairs];
  };
  /// A vector in the frame of a tree, made of the normals of three slabs of a k-DOP.
  struct Slabs {
    int low[3];  ///< the places of the bounds that it begins at: those from below, then from above
    int high[3];
    double weight[3];
  };
  /// The numbers that are added to where things of A begin and end, so that they are comparable
  /// with those of B and lie beside each other only if they never meet.
  struct Shifts {
    TwoLanes low[kPairs];
    TwoLanes high[kPairs];
  };

  CastDirections(const CastPlanes& planes, const double (&direction)[3]);
  void shift(Side side, Pairs pairs, Span& span) const {
    if (side == Side::B) return;
    for (int i = first_of(pairs); i < kPairs; ++i) {
      span.low[i] += shifts_.low[i];
      span.high[i] += shifts_.high[i];
    }
  }
  static int first_of(Pairs pairs) { return pairs == Pairs::All ? 0 : kPairs - 1; }
  void set(int at, const double (&n)[3]);

  CastPlanes planes_;
  double normal_[3] = {0, 0, 0};
  Rows vectors_;             ///< the vectors for coordinates in the units of the sweep
  Slabs slabs_[2 * kPairs];  ///< the vectors for local coordinates of A's tree
  Shifts shifts_;
  TwoLanes down_;  ///< the factors of the low ends of the last pair in the bound of s from below
};

inline double CastDirections::first_contact(const Span& a, const Span& b, double limit) const {
  using narrowphase::are_greater, narrowphase::either_of;
  constexpr int kLast = kPairs - 1;
  TwoLanes beside = are_greater(b.low[kLast], a.high[kLast]);
  for (int i = 0; i < kLast; ++i) {
    beside = either_of(
        beside, either_of(are_greater(b.low[i], a.high[i]), are_greater(a.low[i], b.high[i])));
  }
  const TwoLanes lower = (a.low[kLast] - b.high[kLast]) * down_;
  const double bound = std::max(0.0, std::max(lower[0], lower[1]));
  const bool is_never = narrowphase::sign_bits(beside) != 0 || bound > limit;
  return is_never ? std::numeric_limits<double>::infinity() : bound;
}

}  // namespace graze::contacts
