// Contacts of meshes with height fields follow the surface beyond what is near, however far: they
// are those of the whole field's mesh.

#include <graze/engine/world/height_field.h>
#include <graze/engine/world/manifold.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

double hill(double x, double y) {
  return 2 * std::sin(0.3 * x) + 1.5 * std::cos(0.2 * y);
}

TEST(HeightFieldMeshContacts, AreThoseOfTheWholeFieldsMesh) {
  RandomSource source(41);
  constexpr std::uint32_t kSide = 41;
  std::vector<float> heights;
  for (std::uint32_t row = 0; row < kSide; ++row) {
    for (std::uint32_t column = 0; column < kSide; ++column)
      heights.push_back(static_cast<float>(hill(column, row) + source.uniform(0, 0.2)));
  }
  const HeightField field(kSide, kSide, std::span<const float>(heights));
  const Mesh mesh = field.mesh();
  std::size_t touching = 0;
  for (int i = 0; i < 3000 && !HasFailure(); ++i) {
    const double size = source.uniform(0.1, 0.6);
    const Shape body = tests::make_box({size, 0.3, 0.1});
    Pose pose = tests::random_pose(0, source);
    const double x = source.uniform(0, kSide - 1), y = source.uniform(0, kSide - 1);
    pose.translation() = Eigen::Vector3d(x, y, hill(x, y) + source.uniform(-0.5, 0.5));
    const ManifoldSettings settings{.margin = i % 3 == 0 ? 0.02 : 0};
    const Manifold wanted = find_contacts({body, pose}, {mesh}, settings);
    EXPECT_TRUE(find_contacts({body, pose}, {field}, settings) == wanted) << i;
    EXPECT_TRUE(find_contacts({field}, {body, pose}, settings) ==
                find_contacts({mesh}, {body, pose}, settings))
        << i;
    touching += !wanted.empty();
  }
  EXPECT_GT(touching, 1500u);
}

/// Fine cells: where a box comes through the surface in several places, what lies inside or rises
/// goes on for a hundred cells.
TEST(HeightFieldMeshContacts, GoAsFarAsTheSurfaceLeads) {
  RandomSource source(43);
  constexpr std::uint32_t kSide = 401;
  constexpr double kSpacing = 0.25;
  std::vector<float> heights;
  for (std::uint32_t row = 0; row < kSide; ++row) {
    for (std::uint32_t column = 0; column < kSide; ++column) {
      const double height = hill(column * kSpacing, row * kSpacing);
      heights.push_back(static_cast<float>(height + source.uniform(0, 0.05)));
    }
  }
  const HeightField field(kSide, kSide, std::span<const float>(heights),
                          {.spacing_x = kSpacing, .spacing_y = kSpacing});
  const Mesh mesh = field.mesh();
  for (int i = 0; i < 480 && !HasFailure(); ++i) {
    const double size = source.uniform(0.1, 0.6);
    const Shape body = tests::make_box({size, 0.3, 0.1});
    Pose pose = tests::random_pose(0, source);
    const double x = source.uniform(0, 100), y = source.uniform(0, 100);
    pose.translation() = Eigen::Vector3d(x, y, hill(x, y) + source.uniform(-0.2, 0.8));
    EXPECT_TRUE(find_contacts({body, pose}, {field}) == find_contacts({body, pose}, {mesh})) << i;
  }
}

}  // namespace
}  // namespace graze
