// Each sign is that of a polynomial in e, and so the sign of its first coefficient that is not
// zero. Edelsbrunner and Mücke, "Simulation of simplicity", 1990.

#include <graze/narrowphase/derived/sign_of_products.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/ray/face_sample.h>

namespace graze::narrowphase {
namespace {

constexpr double kNoStep[3] = {0, 0, 0};
constexpr double kUnitSteps[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Step unit_step(int axis) {
  return {kNoStep, kUnitSteps[axis]};
}

Sign product(Sign s, Sign t) {
  return static_cast<Sign>(static_cast<int>(s) * static_cast<int>(t));
}

struct SampleSteps {
  explicit SampleSteps(const FaceSample& sample)
      : at(sample.triangle.a.data()),
        first{at, sample.triangle.b.data()},
        second{at, sample.triangle.c.data()},
        side(sample.side) {}

  const double* at;
  Step first;
  Step second;
  Sign side;
};

/// The side of the line through an edge on which the sample is seen along an axis. Zero only for an
/// edge that is seen as a point.
Sign side_of_edge(const double* u, const double* v, const SampleSteps& sample, int axis) {
  const Step edge{u, v};
  const Step along = unit_step(axis);
  Sign sign = orientation_2d(project(u, axis), project(v, axis), project(sample.at, axis));
  if (sign == Sign::Zero) sign = sign_of_triple(edge, sample.first, along);
  if (sign == Sign::Zero) sign = sign_of_triple(edge, sample.second, along);
  if (sign == Sign::Zero)
    sign = product(sample.side, sign_of_cross_products(along, edge, sample.first, sample.second));
  for (int k = 0; k < 3 && sign == Sign::Zero; ++k)
    sign = sign_of_triple(edge, unit_step(k), along);
  return sign;
}

using SampleCorners = const double* const (&)[3];

Sign turn_along(SampleCorners corner, int axis) {
  return orientation_2d(project(corner[0], axis), project(corner[1], axis),
                        project(corner[2], axis));
}

/// The side of the plane of a triangle with area on which the sample lies. Never zero.
Sign side_of_plane(SampleCorners corner, const SampleSteps& sample) {
  const Step f{corner[0], corner[1]};
  const Step g{corner[0], corner[2]};
  Sign sign = orientation_3d(corner[0], corner[1], corner[2], sample.at);
  if (sign == Sign::Zero) sign = sign_of_triple(f, g, sample.first);
  if (sign == Sign::Zero) sign = sign_of_triple(f, g, sample.second);
  if (sign == Sign::Zero)
    sign = product(sample.side, sign_of_cross_products(f, g, sample.first, sample.second));
  for (int k = 0; k < 3 && sign == Sign::Zero; ++k)
    sign = turn_along(corner, k);
  return sign;
}

}  // namespace

LineCrossing cross_axis_line(const Triangle& triangle, const FaceSample& sample, int axis) {
  const double* const corner[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  const SampleSteps steps(sample);
  const Sign first = side_of_edge(corner[0], corner[1], steps, axis);
  if (first == Sign::Zero || side_of_edge(corner[1], corner[2], steps, axis) != first ||
      side_of_edge(corner[2], corner[0], steps, axis) != first)
    return LineCrossing::None;
  // The line goes through the inside of what is seen, which has an area then: neither is zero.
  return side_of_plane(corner, steps) == turn_along(corner, axis) ? LineCrossing::Below
                                                                  : LineCrossing::Above;
}

}  // namespace graze::narrowphase
