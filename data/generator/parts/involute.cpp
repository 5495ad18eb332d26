#include "data/generator/parts/involute.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace graze::generator {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPressureAngle = 20 * kPi / 180;
constexpr double kDedendum = 1.25;  // in modules, like the next
constexpr double kToolRadius = 0.38;

double involute_of(double pressure_angle) {
  return std::tan(pressure_angle) - pressure_angle;
}

// Half the angle of a tooth, from its middle to the flank, on the circle of the reference radius.
double reference_half_angle(const SpurGear& gear) {
  return kPi / (2 * gear.teeth) - gear.thinning / (2 * gear.reference_radius());
}

FlankPoint involute_point(const SpurGear& gear, double radius) {
  const double pressure_angle = std::acos(gear.base_radius() / radius);
  return {radius,
          reference_half_angle(gear) + involute_of(kPressureAngle) - involute_of(pressure_angle)};
}

// The rack rolls on the reference circle of radius r. Its tip is a circle of radius R whose centre
// lies h below the rolling line and x_c beside the middle of the tool's tooth, which is the middle
// of the gap it cuts. When that centre is s beside the pitch point, the tool touches the fillet
// where the line from the pitch point through the centre leaves the circle: contact normals pass
// through the pitch point. The gap's middle has then rolled on by (s - x_c) / r. From s = 0, the
// root circle, to s = h / tan(20 degrees), where that line is normal to the tool's straight flank.
FlankPoint fillet_point(const SpurGear& gear, double part) {
  const double m = gear.module;
  const double r = gear.reference_radius();
  const double tool_radius = kToolRadius * m;
  const double h = kDedendum * m - tool_radius;
  const double x_c =
      kPi * m / 4 - h * std::tan(kPressureAngle) - tool_radius / std::cos(kPressureAngle);
  const double s = part * h / std::tan(kPressureAngle);
  const double stretch = 1 + tool_radius / std::hypot(s, h);
  const double x = s * stretch;
  const double y = r - h * stretch;
  const double from_gap = std::atan2(x, y) - (s - x_c) / r;
  return {std::hypot(x, y), kPi / gear.teeth - from_gap - gear.thinning / (2 * r)};
}

}  // namespace

double SpurGear::reference_radius() const {
  return module * teeth / 2;
}
double SpurGear::base_radius() const {
  return reference_radius() * std::cos(kPressureAngle);
}
double SpurGear::tip_radius() const {
  return reference_radius() + module;
}
double SpurGear::root_radius() const {
  return reference_radius() - kDedendum * module;
}

double SpurGear::form_radius() const {
  // Along the line of action the tool's straight flank ends (1.25 - 0.38 (1 - sin 20)) m / sin 20
  // before the pitch point; the involute begins r sin 20 before it.
  const double sine = std::sin(kPressureAngle);
  const double depth = (kDedendum - kToolRadius * (1 - sine)) * module;
  const double from_base = reference_radius() * sine - depth / sine;
  if (from_base < 0) throw std::domain_error("the rack undercuts a gear of so few teeth");
  return std::hypot(from_base, base_radius());
}

std::vector<FlankPoint> flank(const SpurGear& gear, int fillet_steps, int involute_steps) {
  std::vector<FlankPoint> points;
  for (int i = 0; i < fillet_steps; ++i) {
    points.push_back(fillet_point(gear, static_cast<double>(i) / fillet_steps));
  }
  // The roll angle of a point of the involute is sqrt((radius / base radius)^2 - 1).
  const double base = gear.base_radius();
  const double first = std::sqrt(std::pow(gear.form_radius() / base, 2) - 1);
  const double last = std::sqrt(std::pow(gear.tip_radius() / base, 2) - 1);
  for (int i = 0; i <= involute_steps; ++i) {
    const double roll = first + (last - first) * i / involute_steps;
    points.push_back(involute_point(gear, base * std::hypot(1, roll)));
  }
  return points;
}

}  // namespace graze::generator
