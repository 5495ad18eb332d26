#include <graze/bvh/wide/tree/node_axes.h>
#include <graze/bvh/wide/tree/range_moments.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

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

CornerRows random_rows(std::size_t count) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<float> uniform(-1, 1);
  CornerRows rows(count);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < count; ++i)
        rows.row(c, k)[i] = uniform(random);
    }
  }
  return rows;
}

/// Corner by corner.
RangeMoments moments_of(const CornerRows& rows, std::size_t begin, std::size_t end) {
  RangeMoments moments;
  for (std::size_t i = begin; i < end; ++i) {
    double edge[2][3];
    for (std::size_t c = 0; c < 3; ++c) {
      double p[3];
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = rows.row(c, k)[i];
        if (c > 0) edge[c - 1][k] = p[k] - rows.row(0, k)[i];
      }
      for (std::size_t k = 0; k < 3; ++k) {
        moments.sum[k] += p[k];
        moments.products[k] += p[k] * p[k];
        moments.products[3 + k] += p[k] * p[(k + 1) % 3];
      }
    }
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double n =
          edge[0][(k + 1) % 3] * edge[1][(k + 2) % 3] - edge[0][(k + 2) % 3] * edge[1][(k + 1) % 3];
      moments.normal[k] += n;
      square += n * n;
    }
    moments.area += std::sqrt(square);
  }
  return moments;
}

TEST(MomentSums, KnowEachRange) {
  for (std::size_t count = 1; count <= 13; ++count) {
    const CornerRows rows = random_rows(count);
    const MomentSums sums(rows);
    for (std::size_t begin = 0; begin < count; ++begin) {
      for (std::size_t end = begin + 1; end <= count; ++end) {
        const RangeMoments found = sums.of(begin, end);
        const RangeMoments expected = moments_of(rows, begin, end);
        EXPECT_NEAR(found.area, expected.area, 1e-13);
        for (int k = 0; k < 6; ++k)
          EXPECT_NEAR(found.products[k], expected.products[k], 1e-13);
        for (int k = 0; k < 3; ++k) {
          EXPECT_NEAR(found.normal[k], expected.normal[k], 1e-13);
          EXPECT_NEAR(found.sum[k], expected.sum[k], 1e-13);
        }
      }
    }
  }
}

}  // namespace
}  // namespace graze::bvh
