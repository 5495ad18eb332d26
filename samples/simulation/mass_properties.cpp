#include "samples/simulation/mass_properties.h"

#include <graze/bvh/error.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace graze::samples {

// For a tetrahedron with one corner at the origin and the others p, q, r, the volume is det(p, q,
// r) / 6, the centre s / 4 with s = p + q + r, and the integral of x x^T is det / 120 (s s^T + p
// p^T + q q^T + r r^T).
MassProperties mass_properties(const Mesh& mesh, double kilograms_per_cubic_metre) {
  double volume = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const auto& [p, q, r] = mesh.triangle(i);
    const double det = p.dot(q.cross(r));
    const Eigen::Vector3d sum = p + q + r;
    volume += det / 6;
    moment += det / 24 * sum;
    second += det / 120 *
              (sum * sum.transpose() + p * p.transpose() + q * q.transpose() + r * r.transpose());
  }
  if (!(volume > 0)) throw InputError("mass of a mesh: it encloses no volume");
  const Eigen::Vector3d centre = moment / volume;
  second -= volume * centre * centre.transpose();
  const Eigen::Matrix3d inertia =
      kilograms_per_cubic_metre * (second.trace() * Eigen::Matrix3d::Identity() - second);
  return {kilograms_per_cubic_metre * volume, centre, inertia, inertia.inverse()};
}

}  // namespace graze::samples
