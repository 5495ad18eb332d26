#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_separation.h>

#include <string>

namespace graze {
namespace {

void check_is_convex(const Shape& shape, const char* name) {
  if (shape.kind() != ShapeKind::Mesh && shape.kind() != ShapeKind::HeightField) return;
  throw UnsupportedPairError(std::string("find_separation: ") + name +
                             " is a mesh, which is a surface and has no depth");
}

/// Returns the separation by the first contact: the contacts begin with the deepest region, and a
/// region with its deepest contact.
ShapeSeparation deepest_of(const Manifold& contacts, PairStatus status) {
  const ShapeContact& deepest = contacts[0];
  return {0 - deepest.depth, deepest.point_a, deepest.point_b, deepest.normal, status};
}

}  // namespace

ShapeSeparation find_separation(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                                Work* work) {
  return bvh::in_standard_arithmetic([&]() -> ShapeSeparation {
    check_is_convex(shape_a.shape, "shape A");
    check_is_convex(shape_b.shape, "shape B");
    CountedWork counted(work);
    const ShapeDistance apart = distance(shape_a, shape_b, &counted.work());
    if (apart.distance > 0)
      return {apart.distance, apart.point_a, apart.point_b, apart.normal, apart.status};
    Work of_contacts;
    const Manifold contacts = find_contacts(shape_a, shape_b, &of_contacts);
    counted.work() += of_contacts;
    return deepest_of(contacts, of_contacts.penetration_failures == 0 ? PairStatus::Converged
                                                                      : PairStatus::NotConverged);
  });
}

}  // namespace graze
