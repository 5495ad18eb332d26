// Each sign is that of a polynomial in e, and so the sign of its first coefficient that is not
// zero. Edelsbrunner and Mücke, "Simulation of simplicity", 1990.

#include <graze/narrowphase/derived/sign_of_products.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/ray/face_sample.h>
#include <graze/narrowphase/ray/sample_steps.h>

namespace graze::narrowphase {
namespace {

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

/// Returns the side of the line through an edge on which the sample is seen along an axis. It is
/// zero only for an edge that is seen as a point.
Sign side_of_edge(const double* u, const double* v, const SampleSteps& sample, int axis) {
  const Step edge{u, v};
  const Step along = unit_step(axis);
  Sign sign = orientation_2d(project(u, axis), project(v, axis), project(sample.at, axis));
  if (sign == Sign::Zero) sign = sign_of_triple(edge, sample.first, along);
  if (sign == Sign::Zero) sign = sign_of_triple(edge, sample.second, along);
  if (sign == Sign::Zero)
    sign = product(sample.side, sign_of_cross_products(along, edge, sample.first, sample.second));
  return sign == Sign::Zero ? last_side_of_edge(edge, axis) : sign;
}

/// Returns the side of the plane of a triangle with area on which the sample lies. It is never
/// zero.
Sign side_of_plane(SampleCorners corner, const SampleSteps& sample) {
  const Step f{corner[0], corner[1]};
  const Step g{corner[0], corner[2]};
  Sign sign = orientation_3d(corner[0], corner[1], corner[2], sample.at);
  if (sign == Sign::Zero) sign = sign_of_triple(f, g, sample.first);
  if (sign == Sign::Zero) sign = sign_of_triple(f, g, sample.second);
  if (sign == Sign::Zero)
    sign = product(sample.side, sign_of_cross_products(f, g, sample.first, sample.second));
  return sign == Sign::Zero ? last_side_of_plane(corner) : sign;
}

}  // namespace

LineCrossing cross_axis_line(const Triangle& triangle, const FaceSample& sample, int axis) {
  const double* const corner[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  const SampleSteps steps(sample);
  return crossing_by_sides(
      corner, axis,
      [&](const double* u, const double* v) { return side_of_edge(u, v, steps, axis); },
      [&] { return side_of_plane(corner, steps); });
}

}  // namespace graze::narrowphase
