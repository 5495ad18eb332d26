#pragma once

// A ball moves by t d, d being its displacement, and a triangle stays. The squared distance of the
// centre from the triangle is a convex function of t, so that they meet in a closed interval of
// times. Where that begins after 0, the point met is the foot of the centre on a corner, on the
// line of an edge or on the plane of the face, and the squared distance from that comes down to r^2
// there: the time is the smaller root of a polynomial of degree two. So it is the least of seven
// such roots, of those at which the foot is on the feature.

#include <graze/bvh/sphere.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/predicates.h>

#include <optional>

namespace graze::narrowphase {

/// Holds where the ball is at t = 0, and d. All that it points to must outlive it.
struct MovingBall {
  const double* centre;
  double radius;
  const double* displacement;

  MovingBall(const Sphere& ball, const double* d)
      : centre(ball.centre.data()), radius(ball.radius), displacement(d) {}
};

/// A part of a triangle that a ball can meet.
struct BallFeature {
  enum class Kind { Vertex, Edge, Face };
  Kind kind;
  int place;  ///< the corner; for an edge the corner that it leaves; 0 for the face

  bool operator==(const BallFeature&) const = default;
};

/// Says what meets first, and when, rounded down.
struct BallMeeting {
  BallFeature feature;
  double time;
};

/// Says where a first meeting is looked for: up to `from` the two are known to be apart, and what
/// meets first after `until` is of no interest.
struct BallStretch {
  double from = 0;
  double until = 1;
};

/// Finds the first meeting in (0, 1] with a triangle from which the ball is apart at t = 0. The
/// answer is exact up to the end of the stretch; what meets later may be reported as later still,
/// or not at all.
std::optional<BallMeeting> first_meeting(const Corners<double>& triangle, const MovingBall& ball,
                                         const BallStretch& stretch);

/// Says where a ball meets one of several triangles.
struct TriangleMeeting {
  const Corners<double>& triangle;
  const BallMeeting& meeting;
};
/// Returns the sign of the time of s less that of t. Exact.
Sign compare(const TriangleMeeting& s, const TriangleMeeting& t, const MovingBall& ball);

/// True if the inside of the ball meets the triangle, which it touches at t = 0, then or at all
/// times directly after. Exact.
bool goes_in_from_start(const Corners<double>& triangle, const MovingBall& ball);

/// Says where a ball and a triangle meet.
struct BallPlace {
  Eigen::Vector3d point;   ///< a point of the triangle: each coordinate is off by at most 0.52 ulp
                           ///< of the largest of the triangle
  Eigen::Vector3d normal;  ///< the direction from the point to the centre, unit to a few ulp
};

/// Returns where they meet. For a ball without a radius the normal is that of the face, and where
/// it meets an edge or a corner, a direction against d.
BallPlace place_of(const TriangleMeeting& meeting, const MovingBall& ball);

/// Returns the point of the triangle nearest to the centre at t = 0. Where that is the centre the
/// normal is that of the triangle, against d; against d where there is none; zero if d is, too.
BallPlace place_at_start(const Corners<double>& triangle, const MovingBall& ball);

}  // namespace graze::narrowphase
