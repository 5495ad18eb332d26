#include "data/generator/parts/thread_profile.h"

#include <cmath>
#include <numbers>

#include "data/generator/parts/tolerances.h"

namespace graze::generator {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
const double kTan30 = std::tan(30 * kDegree);

// The rounded root touches the flanks 60 degrees to either side of its deepest point.
constexpr double kRootAngles[] = {-60 * kDegree, -20 * kDegree, 20 * kDegree, 60 * kDegree};

}  // namespace

double BasicThread::height() const {
  return std::sqrt(3.0) / 2 * pitch;
}
double BasicThread::pitch_diameter() const {
  return diameter - 2 * 3.0 / 8 * height();
}
double BasicThread::minor_diameter() const {
  return diameter - 2 * 5.0 / 8 * height();
}

ThreadProfile external_profile(const BasicThread& basic, double range_mean) {
  const ThreadTolerances allowed = tolerances_6h_6g(basic.pitch, range_mean);
  const double crest = (basic.diameter + allowed.external_major.middle()) / 2;
  const double middle = (basic.pitch_diameter() + allowed.external_pitch.middle()) / 2;
  // On the pitch cylinder ridge and groove are P/2 wide each.
  const double crest_half_width = basic.pitch / 4 - (crest - middle) * kTan30;
  // The flanks of a groove meet at `apex`; a circle of radius R that touches both of them has its
  // centre R / sin 30 = 2R further out.
  const double apex = middle - basic.pitch / 4 / kTan30;
  const double radius = basic.height() / 6;
  ThreadProfile profile{basic.pitch, {{crest, -crest_half_width}, {crest, crest_half_width}}};
  for (double angle : kRootAngles) {
    profile.points.push_back(
        {apex + 2 * radius - radius * std::cos(angle), basic.pitch / 2 + radius * std::sin(angle)});
  }
  return profile;
}

ThreadProfile internal_profile(const BasicThread& basic, double range_mean) {
  const ThreadTolerances allowed = tolerances_6h_6g(basic.pitch, range_mean);
  const double crest = (basic.minor_diameter() + allowed.internal_minor.middle()) / 2;
  const double middle = (basic.pitch_diameter() + allowed.internal_pitch.middle()) / 2;
  const double crest_half_width = basic.pitch / 4 - (middle - crest) * kTan30;
  const double apex = middle + basic.pitch / 4 / kTan30;
  const double radius = basic.height() / 12;
  ThreadProfile profile{basic.pitch, {}};
  for (double angle : kRootAngles) {
    profile.points.push_back(
        {apex - 2 * radius + radius * std::cos(angle), radius * std::sin(angle)});
  }
  profile.points.push_back({crest, basic.pitch / 2 - crest_half_width});
  profile.points.push_back({crest, basic.pitch / 2 + crest_half_width});
  return profile;
}

}  // namespace graze::generator
