// The ray is taken into the frame of the mesh's tree, by the derivation of relative_frame.cpp,
// whose names these are. A point p of a placed triangle has y = R^T (p - P) within 3 dev r + 3.5
// placing of the node's box, and one of the ray, o + s d, has y = R^T (o - P) + s R^T d. The first
// term as computed is off by 10 u |o - P|, components of the second, |d| being less than 4, by 28
// u; the walk takes components below 2^-60 for that, and moves the origin to the mesh, which rounds
// no more than the first term. A ray point near enough to meet the mesh has s < 4 r + 4 |R^T (o -
// P)|, as the largest component of R^T d is more than 1/2. So 3 dev r + 4 placing + 256 u (r + |o -
// P|) covers all, the last term of which the walk adds (bvh/rays/ray_start-inl.h).

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/rays/large_pages.h>
#include <graze/bvh/value/power_of_two.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/data/mesh_rays.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace graze {
namespace {

/// Gives law 5's local coordinates of triangles' corners.
class RayCorners : public bvh::LocalCorners {
 public:
  RayCorners(const Mesh& mesh, const bvh::LocalFrame& frame)
      : vertices_(mesh.vertices()),
        triangles_(mesh.triangles()),
        frame_(frame),
        scale_(bvh::power_of_two(-frame.exponent)) {}

  void of(std::uint32_t primitive, double (&corners)[3][3]) const override {
    for (std::size_t c = 0; c < 3; ++c) {
      const double* p = vertices_[triangles_[primitive][c]].data();
      for (std::size_t k = 0; k < 3; ++k)
        corners[c][k] = (p[k] - frame_.centre[k]) * scale_;
    }
  }

  std::span<const TriangleIndices> numbers() const override { return triangles_; }

 private:
  std::span<const Eigen::Vector3d> vertices_;
  std::span<const TriangleIndices> triangles_;
  const bvh::LocalFrame& frame_;
  double scale_;
};

constexpr double kUnitRoundoff = 0x1p-53;

double largest_component(const double* v) {
  return std::max(std::abs(v[0]), std::max(std::abs(v[1]), std::abs(v[2])));
}

}  // namespace

bvh::RayFrame ray_frame_of(const PlacedMeshView& placed, const bvh::LocalFrame& local) {
  const Aabb& bounds = placed.mesh.bounds();
  const double deviation = check_placement(placed.pose, bounds, "pose of the mesh");
  const double* m = placed.pose.data();  // column-major 4x4
  bvh::RayFrame frame;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i)
      frame.columns[k][i] = m[4 * i + k];
    frame.columns[k][3] = 0;
  }
  const Eigen::Vector3d centre = narrowphase::place(
      placed.pose, Eigen::Vector3d(local.centre[0], local.centre[1], local.centre[2]));
  std::copy_n(centre.data(), 3, frame.centre);
  frame.per_metre = bvh::power_of_two(-local.exponent);
  const double largest =
      std::max(largest_component(bounds.min.data()), largest_component(bounds.max.data()));
  const double placing = 8 * kUnitRoundoff * (largest + largest_component(m + 12)) + 0x1p-1070;
  const double radius = 2 * local.unit();
  frame.slack =
      3 * (deviation + 8 * kUnitRoundoff) * radius + 4 * placing + 256 * kUnitRoundoff * radius;
  return frame;
}

const MeshRays& rays_of(const Mesh& mesh, Work* work) {
  const auto& data = MeshAccess::data(mesh);
  const bvh::Tree& tree = tree_of(mesh, work);
  std::call_once(data.rays_flag, [&] {
    bvh::in_standard_arithmetic([&] {
      // The task is isolated, as the building of the tree is.
      tbb::this_task_arena::isolate([&] {
        // These are the parts of a mesh that rays read, wherever they hit.
        bvh::move_to_large_pages(mesh.vertices().data(), mesh.vertices().size_bytes());
        bvh::move_to_large_pages(mesh.triangles().data(), mesh.triangles().size_bytes());
        bvh::move_to_large_pages(tree.primitives.data(),
                                 std::span<const std::uint32_t>(tree.primitives).size_bytes());
        data.rays = std::make_unique<const MeshRays>(
            MeshRays{bvh::ray_tree_over(tree, RayCorners(mesh, tree.frame)),
                     ray_frame_of({mesh}, tree.frame)});
      });
      data.are_rays_made.store(true, std::memory_order_release);
    });
  });
  return *data.rays;
}

}  // namespace graze
