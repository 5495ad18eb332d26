#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>

namespace graze {
namespace {

using enum PairMethod;
using narrowphase::ContactPoint;
using narrowphase::Vec3;

void candidates_in_order(const PlacedShapeView& a, const PlacedShapeView& b,
                         ContactCandidates& candidates, Work& work) {
  switch (pair_method(a.shape.kind(), b.shape.kind())) {
    case ExactSpheres:
    case ExactSphereBox:
    case ClosedForm:
    case Cores:
      return candidates_of_cores(a, b, candidates, work);
    case BoxAxes:
      return candidates_of_boxes(a, b, candidates, work);
    case Plane:
      return candidates_with_plane(a, b, candidates);
    case MeshPlane:
      return candidates_of_mesh_plane(a, b, candidates, work);
    case MeshVolume:
      return candidates_of_mesh_volume(a, b, candidates, work);
    case MeshCore:
      return candidates_of_mesh_core(a, b, candidates, work);
    case Meshes:
      return candidates_of_meshes(a, b, candidates, work);
    case Planes:
      break;
  }
  throw UnsupportedPairError(std::string("contacts of a ") + name_of(a.shape.kind()) + " and a " +
                             name_of(b.shape.kind()) + ": no finite translation parts them");
}

/// Two contacts of one pair of features, as where an edge enters a face and leaves it again, are
/// told apart by their order.
void make_unique(Manifold& manifold) {
  constexpr std::uint64_t kNext = 1ull << 28;
  for (std::size_t i = 1; i < manifold.count; ++i) {
    ContactFeature& feature = manifold.contacts[i].feature;
    for (std::size_t j = 0; j < i; ++j) {
      if (manifold.contacts[j].feature != feature) continue;
      feature.b += kNext;
      j = 0;
    }
  }
}

Manifold manifold_of(ContactCandidates& candidates, bool is_mirrored) {
  narrowphase::reduce(candidates.list, 4);
  const Vec3 origin = to_vec3(candidates.origin);
  Manifold manifold;
  for (const ContactPoint& touch : candidates.list) {
    ShapeContact& contact = manifold.contacts[manifold.count++];
    const Vec3 on_a = (is_mirrored ? touch.point_b : touch.point_a) + origin;
    const Vec3 on_b = (is_mirrored ? touch.point_a : touch.point_b) + origin;
    contact.point = to_eigen((on_a + on_b) * 0.5);
    contact.point_a = to_eigen(on_a);
    contact.point_b = to_eigen(on_b);
    contact.normal = to_eigen(is_mirrored ? -touch.normal : touch.normal);
    contact.depth = touch.depth;
    contact.feature = {touch.feature_a, touch.feature_b};
  }
  make_unique(manifold);
  if (!is_mirrored) return manifold;
  for (std::size_t i = 0; i < manifold.count; ++i)
    std::swap(manifold.contacts[i].feature.a, manifold.contacts[i].feature.b);
  return manifold;
}

}  // namespace

namespace {

/// True where triangles are tested exactly: that they meet is found out along with how.
bool is_one_question(PairMethod method) {
  return method == Meshes || method == MeshVolume;
}

Manifold contacts_of_touching(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  static thread_local ContactCandidates candidates;  // no pair is looked at within another
  candidates.clear();
  const bool is_mirrored = is_swapped(a, b);
  candidates_in_order(is_mirrored ? b : a, is_mirrored ? a : b, candidates, work);
  return manifold_of(candidates, is_mirrored);
}

}  // namespace

Manifold contacts_in_boxes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const PairMethod method = pair_method(a.shape.kind(), b.shape.kind());
  // Two boxes are one question, too, where those around them are known to overlap.
  const bool is_one = is_one_question(method) || method == BoxAxes;
  if (!is_one && !intersect_in_boxes(a, b, work)) return {};
  return contacts_of_touching(a, b, work);
}

template <typename>
Manifold find_contacts(const PlacedShapeView& a, const PlacedShapeView& b, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> Manifold {
    check_poses(a.pose, b.pose);
    CountedWork counted(work);
    if (!is_one_question(pair_method(a.shape.kind(), b.shape.kind())) &&
        !intersects(a, b, &counted.work()))
      return {};
    return contacts_of_touching(a, b, counted.work());
  });
}
template Manifold find_contacts<void>(const PlacedShapeView&, const PlacedShapeView&, Work*);

}  // namespace graze
