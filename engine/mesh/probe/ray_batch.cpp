#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/batch.h>

#include <algorithm>

namespace graze {
namespace {

/// The most rays of a part: enough that what a pose costs does not count, few enough to share.
constexpr std::size_t kMostRaysInAPart = 4096;

void check_rays(std::span<const Ray> rays) {
  for (std::size_t i = 0; i < rays.size(); ++i)
    bvh::check_element("ray", i, "", [&](const char* what) { check_ray(rays[i], what); });
}

}  // namespace

std::vector<std::optional<RayHit>> cast_rays(const PlacedMeshView& mesh, std::span<const Ray> rays,
                                             const BatchSettings& batch, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<std::optional<RayHit>> {
    check_placement(mesh.pose, mesh.mesh.bounds(), "pose of the mesh");
    check_rays(rays);
    std::vector<std::optional<RayHit>> hits(rays.size());
    for_each_part_of_batch(rays.size(), kMostRaysInAPart, batch, work,
                           [&](std::size_t first, std::size_t last, BatchRun& run, Work& own) {
                             std::vector<std::optional<RayHit>> part;
                             cast_rays(mesh, rays.subspan(first, last - first), part, &own);
                             std::move(part.begin(), part.end(),
                                       hits.begin() + static_cast<std::ptrdiff_t>(first));
                             run.add(last - first);
                           });
    return hits;
  });
}

}  // namespace graze
