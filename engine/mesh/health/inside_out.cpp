#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/data/directed_edges.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/health/inside_out.h>
#include <graze/engine/mesh/health/volume_sign.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/pairs/self_pairs.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>

#include <algorithm>
#include <mutex>

namespace graze {
namespace {

using narrowphase::Sign;

std::uint64_t key_of(std::uint32_t surface_a, std::uint32_t surface_b) {
  const auto [low, high] = std::minmax(surface_a, surface_b);
  return static_cast<std::uint64_t>(high) << 32 | low;
}

/// Returns the first triangle that has area.
std::optional<Triangle> face_of(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  for (const std::uint32_t index : triangles) {
    const Triangle triangle = mesh.triangle(index);
    if (!narrowphase::is_degenerate(triangle)) return triangle;
  }
  return std::nullopt;
}

/// Returns the closed surfaces that enclose a point beside a triangle, ascending.
std::vector<std::uint32_t> surfaces_around(const narrowphase::FaceSample& sample, const Mesh& mesh,
                                           const MeshParts& parts, Work& work) {
  std::vector<std::uint32_t> crossed;
  crossed_triangles(mesh, sample, work, crossed);
  for (std::uint32_t& index : crossed)
    index = parts.surface_of[parts.part_of[index]];
  std::sort(crossed.begin(), crossed.end());
  std::vector<std::uint32_t> around;
  for (std::size_t i = 0; i < crossed.size();) {
    const std::uint32_t surface = crossed[i];
    bool is_odd = false;
    for (; i < crossed.size() && crossed[i] == surface; ++i)
      is_odd = !is_odd;
    if (is_odd && surface != MeshParts::kNone) around.push_back(surface);
  }
  return around;
}

bool holds(const std::vector<std::uint32_t>& list, std::uint32_t entry) {
  return std::binary_search(list.begin(), list.end(), entry);
}

}  // namespace

void CrossedParts::note(TrianglePair pair, const MeshParts& of) {
  const std::uint32_t part_a = of.part_of[pair.a], part_b = of.part_of[pair.b];
  const std::uint32_t surface_a = of.surface_of[part_a], surface_b = of.surface_of[part_b];
  if (surface_a != surface_b) {
    surfaces.insert(key_of(surface_a, surface_b));
  } else {
    parts.insert({part_a, part_b});
  }
}

bool CrossedParts::are_met(std::uint32_t surface_a, std::uint32_t surface_b) const {
  return surfaces.contains(key_of(surface_a, surface_b));
}

// A part is judged beside one of its triangles. An oriented one faces outwards as the sign of its
// volume says; another one if the surface that it is of encloses what is behind it there, which is
// so all over it unless something of that surface crosses it.
std::vector<InsideOutPart> inside_out_parts(const Mesh& mesh, const MeshParts& parts,
                                            const CrossedParts& crossed, Work& work) {
  std::vector<InsideOutPart> found;
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    const std::uint32_t surface = parts.surface_of[part];
    const bool is_oriented = parts.is_oriented[part];
    if (surface == MeshParts::kNone) continue;
    if (!is_oriented && (!parts.is_consistent[part] || crossed.parts.contains(part))) continue;
    const std::span<const std::uint32_t> triangles = parts.triangles_of(part);
    const Sign sign = is_oriented ? volume_sign(mesh, triangles) : Sign::Zero;
    const std::optional<Triangle> face = face_of(mesh, triangles);
    if (!face || (is_oriented && sign == Sign::Zero)) continue;
    bool faces_out = sign == Sign::Positive;
    std::vector<std::uint32_t> around;
    if (!is_oriented || parts.size() > 1)
      around = surfaces_around({*face, Sign::Positive}, mesh, parts, work);
    if (!is_oriented) {
      faces_out = holds(surfaces_around({*face, Sign::Negative}, mesh, parts, work), surface);
      if (holds(around, surface) == faces_out) continue;
    }
    const auto depth = static_cast<std::uint32_t>(std::count_if(
        around.begin(), around.end(),
        [&](std::uint32_t other) { return other != surface && !crossed.are_met(surface, other); }));
    if (faces_out == (depth % 2 == 0)) continue;
    found.push_back({triangles.front(), static_cast<std::uint32_t>(triangles.size()), depth});
  }
  return found;
}

bool CrossedParts::meets_any(std::uint32_t surface) const {
  return std::any_of(surfaces.begin(), surfaces.end(), [&](std::uint64_t key) {
    return key >> 32 == surface || (key & 0xffffffff) == surface;
  });
}

std::optional<std::uint32_t> first_inside_out(const Mesh& mesh) {
  const auto& data = MeshAccess::data(mesh);
  std::call_once(data.inside_out_flag, [&] {
    bvh::in_standard_arithmetic([&] {
      const MeshParts parts = parts_of(mesh, directed_edges_of(mesh));
      CrossedParts crossed;
      Work work;
      std::vector<InsideOutPart> found = inside_out_parts(mesh, parts, crossed, work);
      // Mostly that is all: what crosses or touches takes longer to find than all else.
      if (found.empty()) return;
      for_each_self_intersection(
          mesh, work, [&](TrianglePair pair) { crossed.note(pair, parts); }, [](std::size_t) {});
      found = inside_out_parts(mesh, parts, crossed, work);
      for (const InsideOutPart& part : found) {
        if (crossed.meets_any(parts.surface_of[parts.part_of[part.triangle]])) continue;
        data.inside_out = part.triangle;
        return;
      }
    });
  });
  return data.inside_out;
}

}  // namespace graze
