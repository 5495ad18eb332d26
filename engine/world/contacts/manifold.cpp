#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/contact_materials.h>
#include <graze/engine/world/fields/stand_in.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shapes/half_space_pair.h>
#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <span>

namespace graze {
namespace {

using enum PairMethod;
using narrowphase::ContactPoint;
using narrowphase::Vec3;

/// Finds the candidates of a pair in which A's kind is not above B's.
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
      candidates_of_meshes(a, b, candidates, work);
      if (candidates.margin > 0) add_near_triangles(a, b, candidates, work);
      return;
    case Planes:
      break;
  }
  throw UnsupportedPairError(std::string("contacts of a ") + name_of(a.shape.kind()) + " and a " +
                             name_of(b.shape.kind()) + ": no finite translation parts them");
}

/// Makes features unique: two contacts of one pair of features, as where an edge enters a face and
/// leaves it again, are told apart by their order.
void make_unique(Manifold& manifold) {
  constexpr std::uint64_t kNext = 1ull << 28;
  for (std::size_t i = 1; i < manifold.size(); ++i) {
    ContactFeature& feature = manifold[i].feature;
    for (std::size_t j = 0; j < i; ++j) {
      if (manifold[j].feature != feature) continue;
      feature.b += kNext;
      j = 0;
    }
  }
}

/// The candidates of a region, and its depth.
struct Region {
  std::size_t first;
  std::size_t end;
  double depth;
};

}  // namespace

void candidates_of_pair(const PlacedShapeView& a, const PlacedShapeView& b,
                        ContactCandidates& candidates, Work& work) {
  is_swapped(a, b) ? candidates_in_order(b, a, candidates, work)
                   : candidates_in_order(a, b, candidates, work);
}

void write_manifold(ContactCandidates& candidates, bool is_mirrored, Manifold& manifold) {
  candidates.end_region();
  static thread_local std::vector<Region> regions;
  regions.clear();
  for (const std::size_t end : candidates.ends) {
    const std::size_t first = regions.empty() ? 0 : regions.back().end;
    double depth = 0;  // the depth of A grown by the margin
    for (std::size_t i = first; i < end; ++i)
      depth = std::max(depth, candidates.list[i].depth);
    regions.push_back({first, end, depth});
  }
  std::sort(regions.begin(), regions.end(), [](const Region& s, const Region& t) {
    return s.depth != t.depth ? s.depth > t.depth : s.first < t.first;
  });
  const Vec3 origin = to_vec3(candidates.origin);
  std::uint32_t number = 0;
  for (const Region& region : regions) {
    const std::span offered =
        std::span(candidates.list).subspan(region.first, region.end - region.first);
    const std::size_t kept = narrowphase::reduce(
        offered,
        {.most = Manifold::kMostOfRegion, .margin = candidates.margin, .surfaces = nullptr});
    for (ContactPoint& touch : offered.first(kept)) {
      if (candidates.margin > 0) {
        touch.point_a = touch.point_a - touch.normal * candidates.margin;
        touch.depth -= candidates.margin;
      }
      const Vec3 on_a = (is_mirrored ? touch.point_b : touch.point_a) + origin;
      const Vec3 on_b = (is_mirrored ? touch.point_a : touch.point_b) + origin;
      manifold.add({.point = to_eigen((on_a + on_b) * 0.5),
                    .point_a = to_eigen(on_a),
                    .point_b = to_eigen(on_b),
                    .normal = to_eigen(is_mirrored ? -touch.normal : touch.normal),
                    .depth = touch.depth,
                    .feature = {touch.feature_a, touch.feature_b},
                    .region = number,
                    .material_a = 0,
                    .material_b = 0});
    }
    ++number;
  }
  make_unique(manifold);
  if (!is_mirrored) return;
  for (std::size_t i = 0; i < manifold.size(); ++i)
    std::swap(manifold[i].feature.a, manifold[i].feature.b);
}

ContactCandidates& empty_candidates(double margin) {
  static thread_local ContactCandidates candidates;  // no pair is looked at within another
  candidates.clear();
  candidates.margin = margin;
  return candidates;
}

namespace {

/// True for pairs whose triangles are tested exactly, so that contacts tell whether they meet.
bool is_one_question(PairMethod method) {
  return method == Meshes || method == MeshVolume;
}

void find_of_touching(const PlacedShapeView& a, const PlacedShapeView& b, Work& work,
                      Manifold& found) {
  ContactCandidates& candidates = empty_candidates(0);
  candidates_of_pair(a, b, candidates, work);
  write_manifold(candidates, is_swapped(a, b), found);
}

}  // namespace

void contacts_in_boxes(const PlacedShapeView& a, const PlacedShapeView& b, Work& work,
                       Manifold& found) {
  found.clear();
  if (has_plane(a, b)) {
    const HalfSpacePair by(a, b, work);
    if (!by.is_divided()) contacts_in_boxes(by.a(), by.b(), work, found);
    return add_materials(a, b, found, work);
  }
  if (has_field(a, b)) {
    ask_contacts(a, b, {.aside = kContactAside},
                 [&](const PlacedShapeView& s, const PlacedShapeView& t) {
                   contacts_in_boxes(s, t, work, found);
                 });
    return add_materials(a, b, found, work);
  }
  const PairMethod method = pair_method(a.shape.kind(), b.shape.kind());
  // Two boxes need only one question, too, if the boxes around them are known to overlap.
  const bool is_one = is_one_question(method) || method == BoxAxes;
  if (is_one || intersect_in_boxes(a, b, work)) find_of_touching(a, b, work, found);
  add_materials(a, b, found, work);
}

template <typename>
Manifold find_contacts(const PlacedShapeView& a, const PlacedShapeView& b, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> Manifold {
    check_poses(a.pose, b.pose);
    CountedWork counted(work);
    Manifold found;
    if (has_plane(a, b)) {
      const HalfSpacePair by(a, b, counted.work());
      if (!by.is_divided()) found = find_contacts<void>(by.a(), by.b(), &counted.work());
    } else if (has_field(a, b)) {
      ask_contacts(a, b, {.aside = kContactAside},
                   [&](const PlacedShapeView& s, const PlacedShapeView& t) {
                     found = find_contacts<void>(s, t, &counted.work());
                   });
    } else if (is_one_question(pair_method(a.shape.kind(), b.shape.kind())) ||
               intersects(a, b, &counted.work())) {
      find_of_touching(a, b, counted.work(), found);
    }
    add_materials(a, b, found, counted.work());
    return found;
  });
}
template Manifold find_contacts<void>(const PlacedShapeView&, const PlacedShapeView&, Work*);

std::span<const ShapeContact> Manifold::region(std::size_t index) const {
  const auto is_before = [](const ShapeContact& contact, std::size_t number) {
    return contact.region < number;
  };
  const ShapeContact* first = std::lower_bound(begin(), end(), index, is_before);
  const ShapeContact* last = std::lower_bound(first, end(), index + 1, is_before);
  return {first, last};
}

/// Makes room for `count` contacts, which are more than fit into the manifold itself.
void Manifold::make_room(std::size_t count) {
  if (count <= capacity_) return;
  const std::size_t capacity = std::max(count, 2 * capacity_);
  auto larger = std::make_unique<ShapeContact[]>(capacity);
  if (count_ > kMostOfRegion) std::copy_n(all_.get(), count_, larger.get());
  all_ = std::move(larger);
  capacity_ = capacity;
}

void Manifold::add(const ShapeContact& contact) {
  if (count_ < kMostOfRegion) {
    few_[count_++] = contact;
    return;
  }
  // The contact may be one of the manifold's own, which make_room() moves.
  const ShapeContact added = contact;  // NOLINT(performance-unnecessary-copy-initialization)
  make_room(count_ + 1);
  if (count_ == kMostOfRegion) std::copy(few_.begin(), few_.end(), all_.get());
  all_[count_++] = added;
}

}  // namespace graze
