// This is a guess and two proofs. Rounded arithmetic finds about when the ball meets each feature;
// then the floating-point stage of triangle and ball (triangle_sphere.h) is asked a little before
// the first of these times and a little after it. So nothing hangs on how the times were found.

#include <graze/narrowphase/translation/ball_bracket.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

// The room is 64 roundoffs of all lengths together, of which the proofs want some 24
// (triangle_sphere.h), and the rest is for the guess. If that is not enough a meeting is found
// exactly; with more of it times of neighbours are told apart less often.
constexpr double kRoom = 0x1p-47;

/// Holds a meeting with a ball whose centre is 0 at t = 0.
struct RoughMeeting {
  double time = 2;         ///< above 1: none
  Eigen::Vector3d offset;  ///< the offset from the feature to the centre at that time
};

/// Returns the smaller root of |v - t w|^2 = r^2, for what is apart at t = 0; NaN if there is none.
double time_of_approach(const Eigen::Vector3d& v, const Eigen::Vector3d& w, double r) {
  const double a = w.squaredNorm(), b = v.dot(w), c = v.squaredNorm() - r * r;
  return c / (b + std::sqrt(b * b - a * c));
}

class MeetingGuess {
 public:
  MeetingGuess(const Triangle& triangle, const Sphere& ball, const Eigen::Vector3d& d)
      : corner_{triangle.a - ball.centre, triangle.b - ball.centre, triangle.c - ball.centre},
        d_(d),
        radius_(ball.radius) {}

  /// Finds the first meeting. The face comes before all that is around it, and an edge before its
  /// ends.
  RoughMeeting find() {
    const Eigen::Vector3d normal = (corner_[1] - corner_[0]).cross(corner_[2] - corner_[0]);
    if (ask_face(normal)) return first_;
    for (int i = 0; i < 3; ++i)
      ask_edge(corner_[i], corner_[(i + 1) % 3]);
    for (const Eigen::Vector3d& corner : corner_)
      take(time_of_approach(corner, d_, radius_), corner);
    return first_;
  }

  /// Refines the time by a step of Newton's method, where the difference from the radius is small.
  double refined(const RoughMeeting& meeting) const {
    const double length = meeting.offset.norm();
    return meeting.time - (length - radius_) * length / meeting.offset.dot(d_);
  }

  double largest() const {
    double largest = 0;
    for (const Eigen::Vector3d& corner : corner_)
      largest = std::max(largest, corner.lpNorm<Eigen::Infinity>());
    return largest;
  }

 private:
  bool ask_face(const Eigen::Vector3d& normal) {
    const double height = corner_[0].dot(normal), rate = d_.dot(normal);
    const double away = std::copysign(radius_ * normal.norm(), height);
    if (!(std::abs(height) >= std::abs(away))) return false;
    const double time = (height - away) / rate;
    const Eigen::Vector3d centre = time * d_;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d edge = corner_[(i + 1) % 3] - corner_[i];
      if (!(edge.cross(centre - corner_[i]).dot(normal) >= 0)) return false;
    }
    const double share = (time * rate - height) / normal.squaredNorm();
    take(time, centre - share * normal);
    return first_.time <= 1;
  }

  void ask_edge(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d edge = to - from;
    const double time = time_of_approach(from.cross(edge), d_.cross(edge), radius_ * edge.norm());
    const double along = (time * d_ - from).dot(edge), square = edge.squaredNorm();
    if (along >= 0 && along <= square) take(time, from + along / square * edge);
  }

  /// Written so that NaN is not taken.
  void take(double time, const Eigen::Vector3d& foot) {
    if (!(time >= 0 && time < first_.time)) return;
    first_.time = time;
    first_.offset = time * d_ - foot;
  }

  Eigen::Vector3d corner_[3];
  const Eigen::Vector3d& d_;
  double radius_;
  RoughMeeting first_;
};

}  // namespace

std::optional<BallBracket> bracket_meeting(const Triangle& triangle, const Sphere& ball,
                                           const Eigen::Vector3d& d) {
  MeetingGuess guess(triangle, ball, d);
  const RoughMeeting meeting = guess.find();
  if (!(meeting.time <= 1)) return std::nullopt;
  const double time = guess.refined(meeting);
  const double speed = -meeting.offset.dot(d) / meeting.offset.norm();
  const double size = guess.largest() + ball.centre.lpNorm<Eigen::Infinity>() + ball.radius +
                      time * d.lpNorm<Eigen::Infinity>();
  const double room = kRoom * size / speed;
  const BallBracket bracket{time - room, std::min(time + room, 1.0), meeting.offset};
  const bool is_range = bracket.low > 0 && bracket.low < bracket.high;
  if (!is_range || !is_surely_passed(triangle, ball, d, bracket.low) ||
      !is_surely_met(triangle, ball, d, bracket.high))
    return std::nullopt;
  return bracket;
}

}  // namespace graze::narrowphase
