#pragma once

// Holds a ball and a triangle in integers: the signs of polynomials in time say how far the centre
// is from the features of the triangle.

#include <graze/narrowphase/motion/roots.h>
#include <graze/narrowphase/translation/ball_meeting.h>

namespace graze::narrowphase {

/// All features that a ball can meet.
inline constexpr BallFeature kBallFeatures[7] = {
    {BallFeature::Kind::Vertex, 0}, {BallFeature::Kind::Vertex, 1}, {BallFeature::Kind::Vertex, 2},
    {BallFeature::Kind::Edge, 0},   {BallFeature::Kind::Edge, 1},   {BallFeature::Kind::Edge, 2},
    {BallFeature::Kind::Face, 0}};

/// Holds the corners as seen from where the centre is at t = 0, in a unit in which all is whole. A
/// component has at most 2099 bits (BigInteger), a normal 4200, its square 8403, and so do (w x
/// e)^2 and what tells a foot in the face. The polynomial of the face is of degree six: its
/// coefficient in the middle is twice a product of two triple products of 6302 bits, 12605 in all,
/// which is 197 limbs.
class BallFeatures {
 public:
  BallFeatures(const Corners<double>& triangle, const MovingBall& ball);

  /// True if the feature has a length, or an area, where it should.
  bool has(const BallFeature& feature) const;

  /// Returns the squared distance of the centre from the corner, the line of the edge or the plane,
  /// less r^2, times something positive.
  Polynomial gap(const BallFeature& feature) const;

  /// True if the foot of the centre there is on the edge, or the face, ends included; `sign_of(f)`
  /// is the sign of a polynomial at the time in question.
  template <typename SignOf>
  bool is_foot_on(const BallFeature& feature, const SignOf& sign_of) const {
    if (feature.kind == BallFeature::Kind::Vertex) return true;
    const int sides = feature.kind == BallFeature::Kind::Edge ? 2 : 3;
    for (int i = 0; i < sides; ++i) {
      const LinearPath inside = within(feature, i);
      if (sign_of(line(inside.change, inside.start)) == Sign::Negative) return false;
    }
    return true;
  }

  const CommonUnit& unit() const { return unit_; }
  const BigVector& corner(int i) const { return corner_[i]; }
  const BigVector& edge(int i) const { return edge_[i]; }
  const BigVector& normal() const { return normal_; }
  const BigVector& displacement() const { return d_; }

 private:
  /// Returns a path that is not negative while the foot is on the inner side of an end, or of an
  /// edge.
  LinearPath within(const BallFeature& feature, int side) const;

  CommonUnit unit_;
  BigVector corner_[3];  ///< from the centre to corner i
  BigVector edge_[3];    ///< from corner i to the next
  BigVector normal_;
  BigVector d_;
  BigInteger radius2_;
};

}  // namespace graze::narrowphase
