#include <graze/engine/mesh/distance.h>
#include <graze/engine/world/contacts/contact_materials.h>
#include <graze/engine/world/fields/field_cell.h>

namespace graze {

namespace {

/// Finds the material of one shape at a point of the world, metres.
class Materials {
 public:
  Materials(const PlacedShapeView& placed, Work& work) : placed_(placed), work_(work) {
    const auto* mesh = placed.shape.as<Mesh>();
    const auto* field = placed.shape.as<HeightField>();
    if (mesh != nullptr && !mesh->materials().empty()) mesh_ = mesh;
    if (field != nullptr && HeightFieldAccess::data(*field).has_materials) field_ = field;
  }

  bool has_any() const { return mesh_ != nullptr || field_ != nullptr; }

  std::uint16_t at(const Eigen::Vector3d& point) const {
    if (mesh_ != nullptr)
      return mesh_->materials()[nearest_point({*mesh_, placed_.pose}, point, &work_).triangle];
    return field_ != nullptr ? material_near(*field_, placed_.pose, point) : std::uint16_t{0};
  }

 private:
  const PlacedShapeView& placed_;
  Work& work_;
  const Mesh* mesh_ = nullptr;
  const HeightField* field_ = nullptr;
};

}  // namespace

void add_materials(const PlacedShapeView& a, const PlacedShapeView& b, Manifold& found,
                   Work& work) {
  const Materials of_a(a, work), of_b(b, work);
  if (!of_a.has_any() && !of_b.has_any()) return;
  for (std::size_t i = 0; i < found.size(); ++i) {
    found[i].material_a = of_a.at(found[i].point_a);
    found[i].material_b = of_b.at(found[i].point_b);
  }
}

}  // namespace graze
