#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/cast.h>
#include <graze/narrowphase/motion/path_checks.h>
#include <graze/narrowphase/translation/displacement.h>
#include <graze/narrowphase/translation/meeting_time.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <cmath>
#include <string>

namespace graze {
namespace narrowphase {
namespace {

std::optional<FirstContact> cast_of(const Triangle& triangle_a, const Triangle& triangle_b,
                                    const double* d, const CastSettings& settings) {
  const TranslatedPair pair(triangle_a, triangle_b, d);
  if (decide(triangle_a, triangle_b).is_hit) {
    if (settings.start == StartContact::IsLeft && !crosses_from_start(pair)) return std::nullopt;
    return FirstContact{0, true};
  }
  const std::optional<TimedMeeting> first = first_meeting(pair);
  if (!first) return std::nullopt;
  return FirstContact{rounded_down(TimeQuotient(pair, first->meeting)), false};
}

}  // namespace

void check_displacement(const Eigen::Vector3d& displacement) {
  for (int k = 0; k < 3; ++k) {
    if (std::isfinite(displacement.data()[k])) continue;
    throw InputError(std::string("displacement: component ") + "xyz"[k] + " is not finite");
  }
}

}  // namespace narrowphase

std::optional<FirstContact> cast(const Triangle& triangle_a, const Triangle& triangle_b,
                                 const Eigen::Vector3d& displacement,
                                 const CastSettings& settings) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<FirstContact> {
    narrowphase::check_settings(settings);
    narrowphase::check_displacement(displacement);
    narrowphase::check_finite(triangle_a, "triangle A");
    narrowphase::check_finite(triangle_b, "triangle B");
    return narrowphase::cast_of(triangle_a, triangle_b, displacement.data(), settings);
  });
}

}  // namespace graze
