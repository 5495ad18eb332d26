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
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <algorithm>
#include <array>

namespace graze {
namespace {

using narrowphase::BallMeeting;
using narrowphase::Sign;

/// A triangle that the ball meets, and two doubles between which it does: they are apart up to
/// `low`, but for `low` itself where the meeting is known, and meet no later than at `high`.
struct MetTriangle {
  std::uint32_t index;
  Triangle triangle;
  double low = 0;
  double high = 1;
  std::optional<Eigen::Vector3d> normal = {};  ///< roughly the direction from the triangle to the
                                               ///< centre
  std::optional<BallMeeting> meeting = {};     ///< the meeting, once it was asked for
};

/// The ball that goes, for VolumeWalk, and what it has met first. Brackets of times order most
/// triangles; those whose brackets overlap wait side by side, as all around an edge or a corner do
/// that may not be met in the end, and which of them is first is decided exactly when the walk is
/// over.
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
    if (at_start_) return 0;
    return count_ > 0 ? first_[0].high : 1;
  }

  bool ask(std::uint32_t index, const Triangle& triangle,
           const contacts::CastDirections::Span& /*span*/, const MeetingBounds& bounds) {
    if (bounds.low <= 0) {
      const narrowphase::Decision decision = narrowphase::decide(triangle, ball_);
      work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
      if (decision.is_hit) return ask_at_start(index, triangle);
    }
    if (at_start_ || narrowphase::is_surely_passed(triangle, ball_, displacement_, limit()))
      return false;
    MetTriangle met{index, triangle};
    if (const auto bracket = narrowphase::bracket_meeting(triangle, ball_, displacement_)) {
      met.low = bracket->low;
      met.high = bracket->high;
      met.normal = bracket->normal;
    } else {
      met.high = limit();
      if (!find_meeting(met)) return false;
    }
    return take(met);
  }

  bool turn(contacts::CastDirections& directions) {
    if (at_start_) return false;
    const MetTriangle& first = first_[0];
    const Eigen::Vector3d normal = first.normal ? *first.normal : place_of_meeting(first).normal;
    if (!directions.take_normal({normal.x(), normal.y(), normal.z()})) return false;
    span_ = directions.of_ball(ball_);
    return true;
  }

  std::optional<VolumeCast> result() {
    if (at_start_) {
      const auto at = place_at_start(narrowphase::corners_of(at_start_->triangle), moving_);
      return VolumeCast{0, true, at_start_->index, at.point, at.normal};
    }
    if (count_ == 0) return std::nullopt;
    keep_first();
    const narrowphase::BallPlace at = place_of_meeting(first_[0]);
    return VolumeCast{first_[0].meeting->time, false, first_[0].index, at.point, at.normal};
  }

 private:
  static constexpr std::uint32_t kMost = 16;

  struct StartTriangle {
    std::uint32_t index;
    Triangle triangle;
  };

  bool ask_at_start(std::uint32_t index, const Triangle& triangle) {
    if (at_start_ && at_start_->index < index) return false;
    if (start_ == StartContact::IsLeft &&
        !goes_in_from_start(narrowphase::corners_of(triangle), moving_))
      return false;
    at_start_ = {index, triangle};
    return true;
  }

  /// Finds the meeting of a triangle. Returns false if there is none up to `high`.
  bool find_meeting(MetTriangle& met) {
    if (met.meeting) return true;
    ++work_.exact_tests;
    met.meeting =
        first_meeting(narrowphase::corners_of(met.triangle), moving_, {met.low, met.high});
    if (!met.meeting) return false;
    met.low = met.meeting->time;
    met.high = std::min(1.0, narrowphase::next_double(met.low));
    return true;
  }

  /// Takes a triangle in. Returns true if its `high` is the least, so that what is met later is of
  /// no more interest.
  bool take(const MetTriangle& met) {
    if (count_ > 0 && met.low > limit()) return false;
    const auto is_later = [&](const MetTriangle& other) { return other.low > met.high; };
    const auto end = std::remove_if(first_.begin(), first_.begin() + count_, is_later);
    count_ = static_cast<std::uint32_t>(end - first_.begin());
    if (count_ == kMost) keep_first();
    const bool is_sooner = count_ == 0 || met.high < limit();
    first_[count_++] = met;
    if (is_sooner) std::swap(first_[0], first_[count_ - 1]);
    return is_sooner;
  }

  /// Keeps the first one alone.
  void keep_first() {
    find_meeting(first_[0]);
    for (std::uint32_t i = 1; i < count_; ++i) {
      if (is_earlier(first_[i], first_[0])) first_[0] = first_[i];
    }
    count_ = 1;
  }

  bool is_earlier(MetTriangle& met, const MetTriangle& than) {
    if (met.low > than.high) return false;
    find_meeting(met);
    const narrowphase::Corners<double> corners = narrowphase::corners_of(met.triangle);
    const narrowphase::Corners<double> others = narrowphase::corners_of(than.triangle);
    const Sign order = compare({corners, *met.meeting}, {others, *than.meeting}, moving_);
    return order == Sign::Negative || (order == Sign::Zero && met.index < than.index);
  }

  /// Returns the place of a meeting that is known.
  narrowphase::BallPlace place_of_meeting(const MetTriangle& met) const {
    return place_of({narrowphase::corners_of(met.triangle), *met.meeting}, moving_);
  }

  const Sphere& ball_;
  const Eigen::Vector3d& displacement_;
  StartContact start_;
  narrowphase::MovingBall moving_;
  Work& work_;
  contacts::CastDirections::Span span_;
  std::optional<StartTriangle> at_start_;
  std::array<MetTriangle, kMost> first_;  ///< none is surely later than another; of these the one
  std::uint32_t count_ = 0;               ///< with the least `high` is the first
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
    const SweepLine line(displacement, units);
    contacts::CastDirections directions({mesh}, ball, units, line.direction);
    BallMover mover(ball, displacement, settings.start, directions, counted.work());
    VolumeWalk<BallMover>({mesh}, directions, line, mover, counted.work()).run();
    return mover.result();
  });
}

}  // namespace graze
