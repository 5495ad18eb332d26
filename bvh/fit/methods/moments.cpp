#include <graze/bvh/fit/methods/moments.h>
#include <Eigen/Eigenvalues>

namespace graze::bvh {

// It is taken about the mean, so that thin sets far from the middle of their bounds keep their
// digits.
Eigen::Matrix3d covariance(const LocalPoints& points) {
  double mean[3] = {0, 0, 0};
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < points.size(); ++i)
      mean[k] += points.axis(k)[i];
    mean[k] /= static_cast<double>(points.size());
  }
  double sums[6] = {0, 0, 0, 0, 0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points.axis(0)[i] - mean[0];
    const double y = points.axis(1)[i] - mean[1];
    const double z = points.axis(2)[i] - mean[2];
    sums[0] += x * x;
    sums[1] += y * y;
    sums[2] += z * z;
    sums[3] += x * y;
    sums[4] += x * z;
    sums[5] += y * z;
  }
  Eigen::Matrix3d result;
  result << sums[0], sums[3], sums[4], sums[3], sums[1], sums[5], sums[4], sums[5], sums[2];
  return result / static_cast<double>(points.size());
}

Axes principal_axes(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  // The direction of least spread comes last: of the three the first is known best.
  return axes_along(solver.eigenvectors().col(2), solver.eigenvectors().col(1));
}

}  // namespace graze::bvh
