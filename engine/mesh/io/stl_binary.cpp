#include <graze/engine/mesh/io/byte_cursor.h>
#include <graze/engine/mesh/io/position_index.h>
#include <graze/engine/mesh/io/readers.h>
#include <algorithm>
#include <cmath>
#include <string>

namespace graze::mesh_io {
namespace {

constexpr std::size_t kNormalBytes = 3 * sizeof(float);
constexpr std::size_t kAttributeBytes = 2;

std::uint32_t read_corner(ByteCursor& cursor, PositionIndex& positions) {
  Eigen::Vector3d position;
  for (int k = 0; k < 3; ++k) {
    const Place place = cursor.place();
    position[k] = cursor.read<float>("a triangle");
    if (!std::isfinite(position[k])) cursor.fail_at(place, "a coordinate is not finite");
  }
  return positions.add(position);
}

}  // namespace

MeshArrays read_stl_binary(const Source& source, const ReadSettings& settings) {
  ByteCursor cursor(source, kStlHeaderBytes, std::endian::little);
  const Place count_place = cursor.place();
  const std::uint64_t count = cursor.read<std::uint32_t>("the triangle count");
  if (cursor.remaining() != count * kStlTriangleBytes) {
    cursor.fail_at(count_place, "as binary STL, " + std::to_string(count) + " triangles need " +
                                    std::to_string(count * kStlTriangleBytes) + " bytes, but " +
                                    std::to_string(cursor.remaining()) + " follow");
  }
  MeshArrays mesh;
  PositionIndex positions;
  mesh.triangles.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (settings.has_places) mesh.places.push_back(cursor.place());
    cursor.skip(kNormalBytes, "a triangle");
    TriangleIndices& triangle = mesh.triangles.emplace_back();
    for (std::uint32_t& corner : triangle)
      corner = read_corner(cursor, positions);
    cursor.skip(kAttributeBytes, "a triangle");
  }
  mesh.vertices = positions.take_positions();
  return mesh;
}

}  // namespace graze::mesh_io
