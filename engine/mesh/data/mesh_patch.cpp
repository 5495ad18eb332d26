#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/data/mesh_patch.h>

#include <numeric>

namespace graze {

Mesh mesh_of(MeshPatch&& patch) {
  const auto data = MeshAccess::new_data();
  data->vertices = std::move(patch.vertices);
  data->shared_triangles =
      std::make_shared<const std::vector<TriangleIndices>>(std::move(patch.triangles));
  data->triangles = *data->shared_triangles;
  data->bounds = patch.bounds;
  data->ball = ball_around(data->vertices, data->bounds);
  data->vertex_numbers = std::move(patch.vertex_numbers);
  data->triangle_numbers = std::move(patch.triangle_numbers);
  data->is_rim = std::move(patch.is_rim);
  std::call_once(data->welded_flag, [&] {
    data->welded.resize(data->vertices.size());
    std::iota(data->welded.begin(), data->welded.end(), 0u);
  });
  if (patch.tree) {
    std::call_once(data->tree_flag, [&] {
      data->tree = std::make_shared<const AgedTree>(AgedTree{std::move(*patch.tree), {}});
      data->is_tree_made.store(true, std::memory_order_release);
    });
  }
  return MeshAccess::mesh(data);
}

std::span<const std::uint8_t> rim_of(const Mesh& mesh) {
  return MeshAccess::data(mesh).is_rim;
}

MeshNumbers numbers_of(const Mesh& mesh) {
  const auto& data = MeshAccess::data(mesh);
  return {data.vertex_numbers, data.triangle_numbers};
}

}  // namespace graze
