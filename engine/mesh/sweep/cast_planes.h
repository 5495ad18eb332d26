#pragma once

#include <graze/bvh/sphere.h>
#include <graze/engine/mesh/sweep/framed_mesh.h>
#include <graze/engine/mesh/sweep/sweep.h>

#include <limits>

namespace graze::contacts {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Bounds from below how far B goes along d until it meets A, by any vector that is asked; and by
/// the planes of two triangles, along which each is flat.
class CastPlanes {
 public:
  enum class Side { A, B };

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

  /// The limits that one vector sets to the motion.
  struct Limit {
    double sense;       ///< the vector is taken times this: 1, -1, or 0 if it says nothing
    double between;     ///< n . (the centre of A - the centre of B)
    double margin;      ///< the cost of rounding, at most, on either side
    double least_high;  ///< if the difference of two spans ends below it, they never meet
    double most_low;    ///< if the difference of two spans begins above it, they never meet
    double down;        ///< the factor of `low` in the bound of s from below
  };

  /// A vector for one triangle alone: its normal, along which it is flat.
  struct Plane {
    double n[3];  ///< the normal times `limit.sense`
    double low;   ///< the least n . (its corners - the centre of its mesh's tree)
    double high;
    Limit limit;
  };

  /// Takes a direction whose largest component is from 1/2 to 1 in size, or none.
  CastPlanes(const Frame& a, const Frame& b, const SweepUnits& units, const double (&direction)[3]);

  Limit limit_of(const double (&n)[3]) const;

  Plane plane_of(Side side, const Triangle& placed) const;
  /// Returns no more than the least s >= 0 at which the triangle with this plane and one of the
  /// other mesh meet, of which B is moved by s d. It is infinite if there is none, or none up to
  /// `limit`.
  double first_contact(Side side, const Plane& plane, const Triangle& other, double limit) const;

  const Frame& frame(Side side) const { return side == Side::A ? a_ : b_; }
  double per_metre() const { return per_metre_; }

 private:
  void measure_along(Side side, const double (&n)[3], const Triangle& placed, double& low,
                     double& high) const;

  double per_metre_;
  Frame a_;
  Frame b_;
  double direction_[3];
};

}  // namespace graze::contacts
