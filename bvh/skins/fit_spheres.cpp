#include <graze/bvh/fit/sphere_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/skins/fit_skins.h>
#include <graze/bvh/value/parallel.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

FloatSphere fitted(std::span<const Eigen::Vector3d> points) {
  const Sphere sphere = bounding_sphere(points);
  FloatSphere result;
  double centre[3];
  for (int k = 0; k < 3; ++k) {
    result.centre[k] = static_cast<float>(sphere.centre.data()[k]);
    centre[k] = result.centre[k];
  }
  double square = 0;
  for (const Eigen::Vector3d& point : points) {
    const double* p = point.data();
    const double x = p[0] - centre[0];
    const double y = p[1] - centre[1];
    const double z = p[2] - centre[2];
    square = std::max(square, x * x + y * y + z * z);
  }
  // Rounding is a few parts in 2^53 of the radius, for which the step of rounded_up() pays, and
  // kRounding in each coordinate of a point; squares that vanish are below 2^-500.
  result.radius = rounded_up(std::sqrt(square) + 2 * Hulls::kRounding);
  return result;
}

}  // namespace

std::vector<FloatSphere> fit_spheres(const Tree& tree, const Hulls& hulls) {
  std::vector<FloatSphere> skin(tree.nodes.size());
  for_in_parallel(std::size_t{0}, skin.size(), [&](std::size_t node) {
    in_standard_arithmetic([&] { skin[node] = fitted(hulls.below(node)); });
  });
  return skin;
}

}  // namespace graze::bvh
