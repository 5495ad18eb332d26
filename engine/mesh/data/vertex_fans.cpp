#include <graze/engine/mesh/data/mesh_data.h>

namespace graze {

VertexFans fans_of(std::span<const TriangleIndices> triangles,
                   std::span<const std::uint32_t> welded) {
  VertexFans fans;
  fans.first.resize(welded.size() + 1);
  fans.triangles.resize(3 * triangles.size());
  for (const TriangleIndices& triangle : triangles) {
    for (std::uint32_t vertex : triangle)
      ++fans.first[welded[vertex]];
  }
  // This is at first where each vertex's triangles end; then they are filled in from there
  // backwards.
  std::uint32_t end = 0;
  for (std::uint32_t& first : fans.first)
    first = end += first;
  for (std::size_t i = triangles.size(); i-- > 0;) {
    for (std::uint32_t vertex : triangles[i])
      fans.triangles[--fans.first[welded[vertex]]] = static_cast<std::uint32_t>(i);
  }
  return fans;
}

const VertexFans& vertex_fans_of(const Mesh& mesh) {
  const auto& data = MeshAccess::data(mesh);
  std::call_once(data.fans_flag, [&] { data.fans = fans_of(data.triangles, mesh.welded()); });
  return data.fans;
}

}  // namespace graze
