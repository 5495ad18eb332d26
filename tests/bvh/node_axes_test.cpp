#include <graze/bvh/wide/node_axes.h>
#include <gtest/gtest.h>

namespace graze::bvh {
namespace {

void expect_rotation(const NodeAxes& axes) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double dot = 0;
      for (int k = 0; k < 3; ++k)
        dot += double{axes.rows[i][k]} * axes.rows[j][k];
      EXPECT_NEAR(dot, i == j ? 1 : 0, 2.01 * 0x1p-24) << i << " and " << j;
    }
  }
}

RangeMoments flat_patch(const double (&normal)[3]) {
  RangeMoments moments;
  for (int k = 0; k < 3; ++k)
    moments.normal[k] = normal[k];
  moments.area = 1;
  return moments;
}

// Boxes of wide trees are compared as if their axes were unit vectors at right angles but for
// rounding to float (wide_bounds.h).
TEST(NodeAxes, AreARotationForPatchesOfAnyDirection) {
  const double normals[][3] = {{0, 0, 1}, {0.6, 0.64, -0.48}, {1, 0x1p-149, 0}, {-0.7, 0.7, 0.1}};
  for (const auto& normal : normals) {
    RangeMoments moments = flat_patch(normal);
    const double products[6] = {3, 2, 1, 0.5, -0.25, 0.125};
    for (int k = 0; k < 6; ++k)
      moments.products[k] = products[k];
    expect_rotation(axes_of(moments, 3));
  }
}

TEST(NodeAxes, AreARotationWhereSquaresOfTheCovarianceUnderflow) {
  for (const double mixed : {1.2 * 0x1p-537, 1.6 * 0x1p-530, 0x1p-538, 1.1 * 0x1p-510, 0x1p-400}) {
    RangeMoments moments = flat_patch({0, 0, 1});
    moments.products[3] = mixed;  // x y
    expect_rotation(axes_of(moments, 1));
  }
}

}  // namespace
}  // namespace graze::bvh
