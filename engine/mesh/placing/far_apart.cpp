#include <graze/bvh/pose.h>
#include <graze/engine/mesh/placing/far_apart.h>
#include <graze/engine/mesh/placing/placement_check.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace graze {
namespace {

// u = 2^-53. A difference is off by u of itself, its square by 3 u, the sum of three by 5 u, so the
// root by 3.5 u, and 16 u are added. A square below 2^-1022 is off by 2^-1074 at most, and the root
// of three times that is below 2^-536.
constexpr double kRootRounding = 0x10p-53;
constexpr double kRootUnderflow = 0x1p-530;

// A pair of numbers, one of each of the two meshes, in a register of any CPU.
using Both = double __attribute__((vector_size(16)));
using BothBits = std::int64_t __attribute__((vector_size(16)));

/// Returns the absolute values.
inline Both absolute(Both v) {
  return reinterpret_cast<Both>(reinterpret_cast<BothBits>(v) &
                                std::numeric_limits<std::int64_t>::max());
}

// The ball of a placed mesh. u = 2^-53, R, t the pose, o and r the centre and radius, x a vertex,
// dev = max |R^T R - I| <= 1.001e-6 as it is (kMaxRotationDeviation bounds it as measured), s the
// sum of the largest coordinates (MeshBall::sizes), which no coordinate of o or x exceeds, and T =
// s + |t_x| + |t_y| + |t_z|. The spectral norm of R^T R - I is at most 3 dev, so |R (x - o)| <= (1
// + 1.51 dev) r < (1 + 2^-19) r. Law 1 rounds a coordinate of R x + t by at most 4 u * 1.74 s + u
// |t|, and t + R o, which is summed up from t, by 4 u * 1.74 s + 3 u |t|, either below 8 u T: the
// two together are off by 16 u T in each coordinate, by 28 u T in all. With the placed centres P as
// computed, two placed points can be equal only if
//   |P_B - P_A| <= (1 + 2^-19) (r_A + r_B) + 28 u (T_A + T_B).
// As computed, d^2 is off by 6 u of itself and the square of the right side, the
// limit, by a dozen u: it has 2^-18 and 64 u instead, and a difference of 2^-19 is billions of u.
// What underflows is below 2^-1070 where points are placed, and below 2^-1022 in the squares:
// kLeastLimit is more. Where d^2 overflows, d is above 2^511.9, and a limit whose square is finite
// is below 2^512 with the margins in it; T is below 2^1000, so that nothing else overflows, and an
// infinite limit is never exceeded.
constexpr double kLimitOfRadii = 1 + 0x1p-18;
constexpr double kLimitOfRounding = 0x40p-53;
constexpr double kLeastLimit = 0x1p-500;

}  // namespace

MeshBall ball_around(std::span<const Eigen::Vector3d> vertices, const Aabb& bounds) {
  MeshBall ball{};
  for (int k = 0; k < 3; ++k)
    ball.centre[k] = 0.5 * bounds.min.data()[k] + 0.5 * bounds.max.data()[k];
  double most = 0;
  for (const Eigen::Vector3d& vertex : vertices) {
    const double* p = vertex.data();
    const double x = p[0] - ball.centre[0], y = p[1] - ball.centre[1], z = p[2] - ball.centre[2];
    most = std::max(most, (x * x + y * y) + z * z);
  }
  ball.radius = std::sqrt(most) * (1 + kRootRounding) + kRootUnderflow;
  ball.sizes = sum_of_sizes(bounds);
  return ball;
}

bool are_surely_far_apart(const PlacedBall& a, const PlacedBall& b) {
  const double* of_a = a.pose.data();  // column-major 4x4
  const double* of_b = b.pose.data();
  Both m[16];
  for (int i = 0; i < 16; ++i)
    m[i] = Both{of_a[i], of_b[i]};
  // This checks a pose as is_rigid() does, but by the sum of its deviations alone: poses that pass
  // only because each of these is small are left to others.
  const auto product = [&](int i, int j) {
    return m[i] * m[j] + m[i + 1] * m[j + 1] + m[i + 2] * m[j + 2];
  };
  const Both error = (absolute(product(0, 0) - 1) + absolute(product(4, 4) - 1)) +
                     (absolute(product(8, 8) - 1) + absolute(product(0, 4))) +
                     (absolute(product(0, 8)) + absolute(product(4, 8)));
  const Both determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) +
                           m[4] * (m[9] * m[2] - m[1] * m[10]) + m[8] * (m[1] * m[6] - m[2] * m[5]);
  const Both last_row = (absolute(m[3]) + absolute(m[7])) + (absolute(m[11]) + absolute(m[15] - 1));
  const Both sizes =
      Both{a.ball.sizes, b.ball.sizes} + ((absolute(m[12]) + absolute(m[13])) + absolute(m[14]));
  const BothBits is_sure = (error <= kMaxRotationDeviation) & (determinant > 0.0) &
                           (last_row == 0.0) & (sizes < kFarFromOverflow);
  double square = 0;
  for (int i = 0; i < 3; ++i) {
    Both centre = m[12 + i];
    for (int k = 0; k < 3; ++k)
      centre += m[4 * k + i] * Both{a.ball.centre[k], b.ball.centre[k]};
    const double between = centre[1] - centre[0];
    square += between * between;
  }
  const double limit = kLimitOfRadii * (a.ball.radius + b.ball.radius) +
                       (kLimitOfRounding * (sizes[0] + sizes[1]) + kLeastLimit);
  return ((is_sure[0] & is_sure[1]) != 0) & (square > limit * limit);
}

}  // namespace graze
