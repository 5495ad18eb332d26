#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/contact_materials.h>
#include <graze/engine/world/contacts/margin/nearness.h>
#include <graze/engine/world/contacts/sides/enclosure.h>
#include <graze/engine/world/fields/stand_in.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shapes/half_space_pair.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace graze {

using narrowphase::ContactPoint;
using narrowphase::Vec3;

namespace {

// A share of how far points are from the origin beside them; the rounding of points and depths is
// far less.
constexpr double kRounding = 1e-9;

/// Removes the regions of two shapes that are apart whose way out is longer than the margin, as
/// where a triangle can be left only past others that are not near. The ways out of near features
/// are as long as the margin minus the distance.
void drop_ways_of_others(ContactCandidates& candidates) {
  candidates.end_region();
  std::vector<ContactPoint>& list = candidates.list;
  std::size_t kept = 0, first = 0, kept_ends = 0;
  for (const std::size_t end : candidates.ends) {
    double deepest = 0, size = candidates.margin;
    for (std::size_t i = first; i < end; ++i) {
      deepest = std::max(deepest, list[i].depth);
      size = std::max(size, largest(list[i].point_a) + largest(list[i].point_b));
    }
    if (deepest <= candidates.margin + kRounding * size) {
      for (std::size_t i = first; i < end; ++i) {
        list[kept] = list[i];
        list[kept].depth = std::min(list[kept].depth, candidates.margin);
        ++kept;
      }
      candidates.ends[kept_ends++] = kept;
    }
    first = end;
  }
  list.resize(kept);
  candidates.ends.resize(kept_ends);
}

/// Returns a length, metres, such that no two points of the pair are farther apart; of a half-space
/// only the points nearest to those of the other count. Growing a shape by more would add nothing,
/// and depths would lose their last bits beside it.
double width_of(const PlacedShapeView& a, const PlacedShapeView& b) {
  if (a.shape.kind() == ShapeKind::HalfSpace) return width_of(b, a);
  const Aabb box = bounding_aabb({a.shape, a.pose});
  if (const HalfSpace* half_space = b.shape.as<HalfSpace>()) {
    const PlacedHalfSpace plane = placed_half_space(*half_space, b.pose, box.min);
    return std::abs(plane.offset) + 2 * length(to_vec3(box.max) - to_vec3(box.min));
  }
  const Aabb other = bounding_aabb({b.shape, b.pose});
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double low = std::min(box.min.data()[k], other.min.data()[k]);
    const double high = std::max(box.max.data()[k], other.max.data()[k]);
    square += (high - low) * (high - low);
  }
  return std::sqrt(square);
}

/// Adds the nearest points of the pair, in order of kinds.
void add_nearest_points(const PlacedShapeView& a, const PlacedShapeView& b,
                        ContactCandidates& candidates, Work& work) {
  const ShapeDistance found = is_swapped(a, b) ? distance(b, a, &work) : distance(a, b, &work);
  candidates.origin = found.point_a;
  const Vec3 normal = to_vec3(found.normal);
  const Vec3 on_b = to_vec3(found.point_b) - to_vec3(found.point_a);
  candidates.list.push_back({normal * candidates.margin, on_b, normal,
                             std::clamp(candidates.margin - found.distance, 0.0, candidates.margin),
                             narrowphase::kPointFeature, narrowphase::kPointFeature});
}

/// True if a body is where the sides of a mesh count. The two must not touch.
bool is_in(const PlacedShapeView& body, const PlacedShapeView& mesh, const MeshSides& sides,
           Work& work) {
  return sides.kind() != Sides::Surface && Enclosure(body, mesh, sides, work).holds();
}

/// Returns which part of a height field is needed: near by the margin, or behind by a thickness.
FieldNeed need_of(const ManifoldSettings& settings) {
  const double thickness = std::max(settings.sides_a.thickness(), settings.sides_b.thickness());
  return {.room = std::max(settings.margin, thickness), .aside = kContactAside};
}

}  // namespace

void check_margin(double margin, const char* what) {
  if (std::isfinite(margin) && margin >= 0) return;
  throw InputError(std::string(what) + ": the margin is " + bvh::number_text(margin) +
                   ", but must be finite and not negative");
}

bool are_plain(const ManifoldSettings& settings) {
  return settings.margin == 0 && settings.sides_a.kind() == Sides::Surface &&
         settings.sides_b.kind() == Sides::Surface;
}

Nearness nearness(const PlacedShapeView& a, const PlacedShapeView& b,
                  const ManifoldSettings& settings, Work& work) {
  if (has_plane(a, b)) {
    const HalfSpacePair by(a, b, work);
    const Nearness first = nearness(by.a(), by.b(), settings, work);
    if (!by.is_divided() || first != Nearness::Apart) return first;
    return nearness(by.a(1), by.b(1), settings, work);
  }
  if (has_field(a, b)) {
    const StandIns by(a, b, need_of(settings));
    return by.are_near() ? nearness(by.a.view(), by.b.view(), settings, work) : Nearness::Apart;
  }
  if (intersects(a, b, &work)) return Nearness::Touching;
  if (is_in(a, b, settings.sides_b, work) || is_in(b, a, settings.sides_a, work))
    return Nearness::Enclosed;
  const double margin = settings.margin;
  if (margin == 0) return Nearness::Apart;
  const Mesh *mesh_a = a.shape.as<Mesh>(), *mesh_b = b.shape.as<Mesh>();
  if (mesh_a != nullptr && mesh_b != nullptr) {
    return within({*mesh_a, a.pose}, {*mesh_b, b.pose}, margin, {}, &work) ? Nearness::Near
                                                                           : Nearness::Apart;
  }
  const ShapeDistance found = distance(a, b, &work);
  const bool is_known = found.status == PairStatus::Converged;
  return (is_known ? found.distance : found.lower_bound) <= margin ? Nearness::Near
                                                                   : Nearness::Apart;
}

namespace {

/// Writes the contacts of a body and a mesh whose sides count. In the list of candidates the body
/// is A, and the mesh B.
void write_enclosed(const PlacedShapeView& a, const PlacedShapeView& b,
                    const ManifoldSettings& settings, Work& work, Manifold& found) {
  ContactCandidates& candidates = empty_candidates(0);
  const bool is_a_body = is_in(a, b, settings.sides_b, work);
  if (is_a_body) {
    Enclosure(a, b, settings.sides_b, work).add(candidates);
  } else {
    Enclosure(b, a, settings.sides_a, work).add(candidates);
  }
  write_manifold(candidates, !is_a_body, found);
}

double deepest_in(const Manifold& found) {
  return found.empty() ? -std::numeric_limits<double>::infinity() : found[0].depth;
}

/// Returns the relation and the contacts of a pair with one plane, or two.
Nearness contacts_beside_plane(const PlacedShapeView& a, const PlacedShapeView& b,
                               const ManifoldSettings& settings, Work& work, Manifold& found) {
  const HalfSpacePair by(a, b, work);
  const Nearness first = contacts_within(by.a(), by.b(), settings, work, found);
  if (!by.is_divided()) return first;
  Manifold behind;
  const Nearness second = contacts_within(by.a(1), by.b(1), settings, work, behind);
  if (deepest_in(behind) > deepest_in(found)) std::swap(found, behind);
  const auto regions = static_cast<std::uint32_t>(found.region_count());
  for (ShapeContact contact : behind) {
    contact.region += regions;
    found.add(contact);
  }
  return std::max(first, second);
}

}  // namespace

Nearness contacts_within(const PlacedShapeView& a, const PlacedShapeView& b,
                         const ManifoldSettings& settings, Work& work, Manifold& found) {
  found.clear();
  if (has_plane(a, b)) {
    const Nearness nearness = contacts_beside_plane(a, b, settings, work, found);
    add_materials(a, b, found, work);
    return nearness;
  }
  if (has_field(a, b)) {
    Nearness nearness = Nearness::Apart;
    ask_contacts(a, b, need_of(settings), [&](const PlacedShapeView& s, const PlacedShapeView& t) {
      nearness = contacts_within(s, t, settings, work, found);
    });
    add_materials(a, b, found, work);
    return nearness;
  }
  const Nearness nearness = graze::nearness(a, b, settings, work);
  if (nearness == Nearness::Apart) return nearness;
  if (nearness == Nearness::Enclosed) {
    write_enclosed(a, b, settings, work, found);
    add_materials(a, b, found, work);
    return nearness;
  }
  const bool are_planes =
      a.shape.kind() == ShapeKind::HalfSpace && b.shape.kind() == ShapeKind::HalfSpace;
  ContactCandidates& candidates =
      empty_candidates(are_planes ? settings.margin : std::min(settings.margin, width_of(a, b)));
  candidates_of_pair(a, b, candidates, work);
  if (nearness == Nearness::Near) drop_ways_of_others(candidates);
  if (candidates.list.empty()) {
    if (nearness == Nearness::Near) {
      add_nearest_points(a, b, candidates, work);
    } else {  // shapes that touch have contacts without a margin
      candidates.margin = 0;
      candidates_of_pair(a, b, candidates, work);
    }
  }
  write_manifold(candidates, is_swapped(a, b), found);
  add_materials(a, b, found, work);
  return nearness;
}

template <typename>
Manifold find_contacts(const PlacedShapeView& a, const PlacedShapeView& b,
                       const ManifoldSettings& settings, Work* work) {
  check_margin(settings.margin, "find_contacts");
  if (are_plain(settings)) return find_contacts(a, b, work);
  return bvh::in_standard_arithmetic([&]() -> Manifold {
    check_poses(a.pose, b.pose);
    CountedWork counted(work);
    Manifold found;
    check_sides(&a.shape, settings.sides_a, "find_contacts");
    check_sides(&b.shape, settings.sides_b, "find_contacts");
    contacts_within(a, b, settings, counted.work(), found);
    return found;
  });
}
template Manifold find_contacts<void>(const PlacedShapeView&, const PlacedShapeView&,
                                      const ManifoldSettings&, Work*);

}  // namespace graze
