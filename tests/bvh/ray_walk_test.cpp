#include <graze/bvh/box_set/search/ray_walk.h>
#include <gtest/gtest.h>

#include <limits>

namespace graze::bvh {
namespace {

/// What the ray from (`at` - 1, `at`, `at` + 1/2), which sinks by `fall` at each step of 1 along x,
/// enters of the cube of edge 1 with its least corner at (at, at, at).
double entry_of_cube(double at, double fall) {
  const double origin[3] = {at - 1, at, at + 0.5};
  const double direction[3] = {1, -fall, 0};
  const double low[3] = {at, at, at};
  const double high[3] = {at + 1, at + 1, at + 1};
  return padded_entry({origin, direction}, low, high, 10);
}

TEST(RayWalk, BoxesFarFromTheOriginGrowAsNearOnesDo) {
  for (double at : {0.0, 1.0, 1e6, 0x1p40}) {
    EXPECT_EQ(entry_of_cube(at, 8 * kRayPadding), kNever) << at;
    EXPECT_NEAR(entry_of_cube(at, kRayPadding / 2), 1, 1e-9) << at;
  }
}

TEST(RayWalk, NoBoxIsTooLargeToBeMet) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kLargest = std::numeric_limits<double>::max();
  const double origin[3] = {-kLargest, 1, 1};
  const double direction[3] = {1, 0.5, 0.25};
  const RaySlabs ray(origin, direction);
  for (double end : {0.5 * kLargest, kLargest, kInfinity}) {
    const double low[3] = {0.25 * kLargest, -end, -end};
    const double high[3] = {end, end, end};
    EXPECT_EQ(padded_entry(ray, low, high, kInfinity), 0) << end;
  }
}

}  // namespace
}  // namespace graze::bvh
