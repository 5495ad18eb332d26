#include <graze/engine/world/contacts/meshes/piece_facets.h>

#include <algorithm>

namespace graze {

using narrowphase::Vec3;

void PieceFacets::start(std::span<const MeshCrossing> crossings, const InnerSurface& surface_a,
                        const InnerSurface& surface_b) {
  index_.start(crossings);
  facets_.clear();
  find_facets(surface_b, true);
  find_facets(surface_a, false);
  std::sort(facets_.begin(), facets_.end(), [](const Facet& s, const Facet& t) {
    if (s.bound != t.bound) return s.bound < t.bound;
    return s.is_of_a != t.is_of_a ? s.is_of_a : s.triangle < t.triangle;
  });
  for (std::uint32_t n = 0; n < facets_.size(); ++n)
    for (const std::uint32_t i : index_.on_triangle(facets_[n].triangle, facets_[n].is_of_a))
      facet_of(i, facets_[n].is_of_a) = n;
  is_left_.assign(crossings.size(), false);
  for (std::uint32_t i = 0; i < crossings.size(); ++i)
    set_left(i, true);
}

/// Finds the facets, each with the depth of the inner points of its partners: their ends of
/// crossings and corners.
void PieceFacets::find_facets(const InnerSurface& other, bool of_a) {
  const std::span<const MeshCrossing> crossings = index_.crossings();
  facet_of_[of_a].assign(crossings.size(), 0);
  lowest_.assign(crossings.size(), 0);
  for (std::uint32_t i = 0; i < crossings.size(); ++i) {
    const MeshCrossing& crossing = crossings[i];
    const Vec3& normal = of_a ? crossing.normal_a : crossing.normal_b;
    const std::uint32_t partner = of_a ? crossing.pair.b : crossing.pair.a;
    double& lowest = lowest_[i];
    for (const std::uint32_t on : index_.on_triangle_of(i, !of_a))
      lowest = std::min({lowest, dot(normal, crossings[on].from - crossing.from),
                         dot(normal, crossings[on].to - crossing.from)});
    for (const std::uint32_t vertex : other.corners(partner))
      if (other.is_inside(vertex))
        lowest = std::min(lowest, dot(normal, other.placed(vertex) - crossing.from));
  }
  for (std::uint32_t i = 0; i < crossings.size(); ++i) {
    const std::span<const std::uint32_t> on_it = index_.on_triangle_of(i, of_a);
    if (on_it.front() != i) continue;
    const std::uint32_t triangle = of_a ? crossings[i].pair.a : crossings[i].pair.b;
    double lowest = 0;
    for (const std::uint32_t on : on_it)
      lowest = std::min(lowest, lowest_[on]);
    facets_.push_back({.bound = -lowest, .triangle = triangle, .is_of_a = of_a});
  }
}

void PieceFacets::set_left(std::uint32_t crossing, bool is_left) {
  if (static_cast<bool>(is_left_[crossing]) == is_left) return;
  is_left_[crossing] = is_left;
  for (const bool of_a : {false, true}) {
    std::uint32_t& count = facets_[facet_of(crossing, of_a)].pairs_left;
    is_left ? ++count : --count;
  }
}

void PieceFacets::leave(std::span<const TrianglePair> pairs) {
  const std::span<const MeshCrossing> crossings = index_.crossings();
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < crossings.size(); ++i) {
    const bool is_listed = next < pairs.size() && crossings[i].pair == pairs[next];
    next += is_listed;
    set_left(i, is_listed);
  }
}

void PieceFacets::part(std::size_t facet) {
  const Facet of = facets_[facet];
  for (const std::uint32_t i : index_.on_triangle(of.triangle, of.is_of_a))
    set_left(i, false);
}

}  // namespace graze
