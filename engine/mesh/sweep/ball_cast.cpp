#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/sweep/volume_walk.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/narrowphase/motion/path_checks.h>
#include <graze/narrowphase/motion/times.h>
#include <graze/narrowphase/translation/ball_meeting.h>
#include <graze/narrowphase/translation/displacement.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <algorithm>

namespace graze {
namespace {

using narrowphase::BallMeeting;
using narrowphase::Sign;

/// What goes, for VolumeWalk, and what it has met first.
class BallMover {
 public:
  BallMover(const Sphere& ball, const Eigen::Vector3d& displacement, StartContact start,
            const contacts::CastDirections& directions, Work& work)
      : ball_(ball),
        displacement_(displacement),
        start_(start),
        moving_(ball, displacement.data()),
        work_(work),
        span_(directions.of_ball(ball)) {}

  const contacts::CastDirections::Span& span() const { return span_; }
  double limit() const {
    if (!found_) return 1;
    return found_->meeting ? std::min(1.0, narrowphase::next_double(found_->meeting->time)) : 0;
  }

  bool ask(std::uint32_t index, const Triangle& triangle,
           const contacts::CastDirections::Span& /*span*/, const MeetingBounds& bounds) {
    if (bounds.low <= 0) {
      const narrowphase::Decision decision = narrowphase::decide(triangle, ball_);
      work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
      if (decision.is_hit) return ask_at_start(index, triangle);
    }
    if (is_at_start() || narrowphase::is_surely_passed(triangle, ball_, displacement_, limit()))
      return false;
    ++work_.exact_tests;
    const auto meeting = first_meeting(narrowphase::corners_of(triangle), moving_);
    if (!meeting || !is_earlier(index, triangle, *meeting)) return false;
    found_ = Found{index, triangle, meeting};
    return true;
  }

  bool turn(contacts::CastDirections& directions) {
    if (is_at_start()) return false;
    const Eigen::Vector3d normal = place().normal;
    if (!directions.take_normal({normal.x(), normal.y(), normal.z()})) return false;
    span_ = directions.of_ball(ball_);
    return true;
  }

  std::optional<VolumeCast> result() const {
    if (!found_) return std::nullopt;
    const narrowphase::BallPlace at =
        is_at_start() ? place_at_start(narrowphase::corners_of(found_->triangle), moving_)
                      : place();
    return VolumeCast{is_at_start() ? 0 : found_->meeting->time, is_at_start(), found_->index,
                      at.point, at.normal};
  }

 private:
  struct Found {
    std::uint32_t index;
    Triangle triangle;
    std::optional<BallMeeting> meeting;  ///< none if it is at t = 0
  };

  bool is_at_start() const { return found_ && !found_->meeting; }

  bool ask_at_start(std::uint32_t index, const Triangle& triangle) {
    if (is_at_start() && found_->index < index) return false;
    if (start_ == StartContact::IsLeft &&
        !goes_in_from_start(narrowphase::corners_of(triangle), moving_))
      return false;
    found_ = Found{index, triangle, std::nullopt};
    return true;
  }

  bool is_earlier(std::uint32_t index, const Triangle& triangle, const BallMeeting& meeting) const {
    if (!found_) return true;
    const narrowphase::Corners<double> corners = narrowphase::corners_of(triangle);
    const narrowphase::Corners<double> others = narrowphase::corners_of(found_->triangle);
    const Sign order = compare({corners, meeting}, {others, *found_->meeting}, moving_);
    return order == Sign::Negative || (order == Sign::Zero && index < found_->index);
  }

  /// Of what is met after t = 0.
  narrowphase::BallPlace place() const {
    const narrowphase::Corners<double> corners = narrowphase::corners_of(found_->triangle);
    return place_of({corners, *found_->meeting}, moving_);
  }

  const Sphere& ball_;
  const Eigen::Vector3d& displacement_;
  StartContact start_;
  narrowphase::MovingBall moving_;
  Work& work_;
  contacts::CastDirections::Span span_;
  std::optional<Found> found_;
};

}  // namespace

std::optional<VolumeCast> cast(const PlacedMeshView& mesh, const Sphere& ball,
                               const Eigen::Vector3d& displacement, const CastSettings& settings,
                               Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<VolumeCast> {
    CountedWork counted(work);
    narrowphase::check_settings(settings);
    bvh::check_sphere(ball, "ball");
    check_placement(mesh.pose, mesh.mesh.bounds(), "pose of the mesh");
    narrowphase::check_displacement(displacement);
    const contacts::SweepUnits units(mesh, ball);
    const SweptWay way(displacement, units);
    contacts::CastDirections directions({mesh}, ball, units, way.direction);
    BallMover mover(ball, displacement, settings.start, directions, counted.work());
    VolumeWalk<BallMover>({mesh}, directions, way, mover, counted.work()).run();
    return mover.result();
  });
}

}  // namespace graze
