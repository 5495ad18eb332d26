#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/sweep/volume_walk.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/narrowphase/motion/path_checks.h>
#include <graze/narrowphase/motion/times.h>
#include <graze/narrowphase/translation/ball_bracket.h>
#include <graze/narrowphase/translation/ball_meeting.h>
#include <graze/narrowphase/translation/displacement.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <algorithm>

namespace graze {
namespace {

using narrowphase::BallMeeting;
using narrowphase::Sign;

/// A triangle that the ball meets, and two doubles between which it does: they are apart up to
/// `low`, but for `low` itself where the meeting is known, and meet no later than at `high`.
struct FoundTriangle {
  std::uint32_t index;
  Triangle triangle;
  bool is_at_start = false;
  double low = 0;
  double high = 0;
  std::optional<Eigen::Vector3d> normal = {};  ///< roughly, from the triangle to the centre
  std::optional<BallMeeting> meeting = {};     ///< once it was asked for
};

/// What goes, for VolumeWalk, and what it has met first. Brackets of times order most triangles,
/// and only where they overlap meetings are found exactly.
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
  double limit() const { return found_ ? found_->high : 1; }

  bool ask(std::uint32_t index, const Triangle& triangle,
           const contacts::CastDirections::Span& /*span*/, const MeetingBounds& bounds) {
    if (bounds.low <= 0) {
      const narrowphase::Decision decision = narrowphase::decide(triangle, ball_);
      work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
      if (decision.is_hit) return ask_at_start(index, triangle);
    }
    if (is_at_start() || narrowphase::is_surely_passed(triangle, ball_, displacement_, limit()))
      return false;
    FoundTriangle found{index, triangle};
    found.high = limit();
    if (const auto bracket = narrowphase::bracket_meeting(triangle, ball_, displacement_)) {
      found.low = bracket->low;
      found.high = bracket->high;
      found.normal = bracket->normal;
    } else if (!find_meeting(found)) {
      return false;
    }
    if (found_ && !is_earlier(found, *found_)) return false;
    found_ = found;
    return true;
  }

  bool turn(contacts::CastDirections& directions) {
    if (is_at_start()) return false;
    const Eigen::Vector3d normal = found_->normal ? *found_->normal : place().normal;
    if (!directions.take_normal({normal.x(), normal.y(), normal.z()})) return false;
    span_ = directions.of_ball(ball_);
    return true;
  }

  std::optional<VolumeCast> result() {
    if (!found_) return std::nullopt;
    if (is_at_start()) {
      const auto at = place_at_start(narrowphase::corners_of(found_->triangle), moving_);
      return VolumeCast{0, true, found_->index, at.point, at.normal};
    }
    find_meeting(*found_);
    const narrowphase::BallPlace at = place();
    return VolumeCast{found_->meeting->time, false, found_->index, at.point, at.normal};
  }

 private:
  bool is_at_start() const { return found_ && found_->is_at_start; }

  bool ask_at_start(std::uint32_t index, const Triangle& triangle) {
    if (is_at_start() && found_->index < index) return false;
    if (start_ == StartContact::IsLeft &&
        !goes_in_from_start(narrowphase::corners_of(triangle), moving_))
      return false;
    found_ = FoundTriangle{index, triangle, true};
    return true;
  }

  /// False if there is no meeting.
  bool find_meeting(FoundTriangle& found) {
    if (found.meeting) return true;
    ++work_.exact_tests;
    found.meeting = first_meeting(narrowphase::corners_of(found.triangle), moving_, found.high);
    if (!found.meeting) return false;
    found.low = found.meeting->time;
    found.high = std::min(1.0, narrowphase::next_double(found.low));
    return true;
  }

  bool is_earlier(FoundTriangle& found, FoundTriangle& than) {
    if (found.high < than.low) return true;
    if (found.low > than.high) return false;
    find_meeting(found);
    find_meeting(than);
    const narrowphase::Corners<double> corners = narrowphase::corners_of(found.triangle);
    const narrowphase::Corners<double> others = narrowphase::corners_of(than.triangle);
    const Sign order = compare({corners, *found.meeting}, {others, *than.meeting}, moving_);
    return order == Sign::Negative || (order == Sign::Zero && found.index < than.index);
  }

  /// Of a meeting that is known.
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
  std::optional<FoundTriangle> found_;
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
