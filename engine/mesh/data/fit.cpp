#include <graze/bvh/fit/kdop_fit.h>
#include <graze/bvh/fit/measure.h>
#include <graze/bvh/fit/obb_fit.h>
#include <graze/bvh/fit/sphere_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/local_frame.h>
#include <graze/engine/mesh/fit.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace graze {
namespace {

/// Returns the positions that triangles use, each vertex once.
std::vector<Eigen::Vector3d> used_vertices(const Mesh& mesh) {
  std::vector<bool> is_used(mesh.vertices().size(), false);
  for (const TriangleIndices& triangle : mesh.triangles()) {
    for (std::uint32_t vertex : triangle)
      is_used[vertex] = true;
  }
  std::vector<Eigen::Vector3d> used;
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i]) used.push_back(mesh.vertices()[i]);
  }
  return used;
}

/// Neumaier's sum: the rounding errors of all additions are added up beside it.
class CompensatedSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }

  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;
};

bool is_ratio(double numerator, double denominator) {
  return std::isfinite(numerator) && std::isfinite(denominator) && denominator > 0;
}

}  // namespace

Sphere bounding_sphere(const Mesh& mesh) {
  return bvh::in_standard_arithmetic(
      [&]() -> Sphere { return bounding_sphere(used_vertices(mesh)); });
}

Obb bounding_obb(const Mesh& mesh) {
  return bvh::in_standard_arithmetic([&]() -> Obb { return bounding_obb(used_vertices(mesh)); });
}

KDop<18> bounding_kdop(const Mesh& mesh) {
  return bvh::in_standard_arithmetic(
      [&]() -> KDop<18> { return bounding_kdop(used_vertices(mesh)); });
}

double signed_volume(const Mesh& mesh) {
  return bvh::in_standard_arithmetic([&]() -> double {
    const bvh::LocalFrame frame = bvh::LocalFrame::around(mesh.bounds());
    const Eigen::Vector3d centre(frame.centre[0], frame.centre[1], frame.centre[2]);
    const double scale = std::ldexp(1.0, -frame.exponent);
    CompensatedSum six_volumes;
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
      const Triangle triangle = mesh.triangle(i);
      const Eigen::Vector3d a = (triangle.a - centre) * scale;
      const Eigen::Vector3d b = (triangle.b - centre) * scale;
      const Eigen::Vector3d c = (triangle.c - centre) * scale;
      six_volumes.add(a.dot(b.cross(c)));
    }
    const double unit = frame.unit();
    return six_volumes.value() / 6 * unit * unit * unit;
  });
}

MeshFit measure_fit(const Mesh& mesh) {
  return bvh::in_standard_arithmetic([&]() -> MeshFit {
    const Sphere sphere = bounding_sphere(mesh);
    const Obb obb = bounding_obb(mesh);
    const KDop<18> kdop = bounding_kdop(mesh);
    MeshFit fit;
    fit.volumes = {{{Volume::Aabb, volume(mesh.bounds()), surface(mesh.bounds()), {}, {}},
                    {Volume::Sphere, volume(sphere), surface(sphere), {}, {}},
                    {Volume::Obb, volume(obb), surface(obb), {}, {}},
                    {Volume::KDop, volume(kdop), surface(kdop), {}, {}}}};
    const double aabb_volume = fit.volumes[0].volume;
    if (mesh.topology().is_closed) fit.enclosed_volume = std::abs(signed_volume(mesh));
    for (VolumeFit& each : fit.volumes) {
      if (fit.enclosed_volume) {
        if (is_ratio(*fit.enclosed_volume, each.volume)) {
          each.empty_share = std::max(0.0, (each.volume - *fit.enclosed_volume) / each.volume);
        }
      } else if (is_ratio(each.volume, aabb_volume)) {
        each.relative_volume = each.volume / aabb_volume;
      }
    }
    return fit;
  });
}

}  // namespace graze
