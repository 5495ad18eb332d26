#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/cast.h>
#include <graze/narrowphase/motion/path_checks.h>
#include <graze/narrowphase/translation/ball_bracket.h>
#include <graze/narrowphase/translation/ball_meeting.h>
#include <graze/narrowphase/translation/displacement.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

namespace graze {

std::optional<FirstContact> cast(const Triangle& triangle, const Sphere& ball,
                                 const Eigen::Vector3d& displacement,
                                 const CastSettings& settings) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<FirstContact> {
    narrowphase::check_settings(settings);
    narrowphase::check_displacement(displacement);
    narrowphase::check_finite(triangle, "triangle");
    bvh::check_sphere(ball, "ball");
    const narrowphase::Corners<double> corners = narrowphase::corners_of(triangle);
    const narrowphase::MovingBall moving(ball, displacement.data());
    if (narrowphase::decide(triangle, ball).is_hit) {
      if (settings.start == StartContact::IsLeft && !goes_in_from_start(corners, moving))
        return std::nullopt;
      return FirstContact{0, true};
    }
    if (narrowphase::is_surely_passed(triangle, ball, displacement, 1)) return std::nullopt;
    const auto bracket = narrowphase::bracket_meeting(triangle, ball, displacement);
    const narrowphase::BallStretch stretch =
        bracket ? narrowphase::BallStretch{bracket->low, bracket->high}
                : narrowphase::BallStretch{};
    const auto first = first_meeting(corners, moving, stretch);
    if (!first) return std::nullopt;
    return FirstContact{first->time, false};
  });
}

}  // namespace graze
