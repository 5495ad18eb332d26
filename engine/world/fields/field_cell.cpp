#include <graze/engine/mesh/data/mesh_patch.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/world/fields/field_cell.h>
#include <graze/engine/world/fields/field_patch.h>
#include <graze/engine/world/fields/field_query.h>

#include <algorithm>
#include <cmath>

namespace graze {

std::uint8_t material_near(const HeightField& field, const Pose& pose,
                           const Eigen::Vector3d& point) {
  const HeightFieldData& data = HeightFieldAccess::data(field);
  FieldQuery query(data, pose, Aabb{point, point});
  const CellSquare square = nearest_square(data, query);
  const CellRect cells = data.cells_of(square);
  const Mesh mesh = kept_patch_of(data, cells);
  query.grow(nearest_point({mesh, pose}, point).distance);
  std::uint32_t nearest = 0xffffffffu;
  double least = 0;
  for (const CellSquare& each : squares_met(data, query)) {
    const Mesh patch = kept_patch_of(data, data.cells_of(each));
    const NearestPoint found = nearest_point({patch, pose}, point);
    const std::uint32_t number = numbers_of(patch).triangle(found.triangle);
    const bool is_first = nearest == 0xffffffffu || found.distance < least ||
                          (found.distance == least && number < nearest);
    if (is_first) nearest = number, least = found.distance;
  }
  const std::uint32_t cell = nearest / 2;
  return data.material(cell % data.cell_columns(), cell / data.cell_columns());
}

}  // namespace graze
