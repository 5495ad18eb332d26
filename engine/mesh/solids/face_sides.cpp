#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/solids/face_sides.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>
#include <graze/narrowphase/triangle_pair/inside_contact.h>

#include <algorithm>
#include <vector>

namespace graze {

using narrowphase::Sign;

bool FaceSides::has_area(std::uint32_t index) const {
  return !narrowphase::is_degenerate(triangle(index));
}

std::optional<std::uint32_t> FaceSides::intruder(std::uint32_t index) {
  const auto known = intruders_.find(index);
  if (known != intruders_.end()) return known->second;
  const Triangle asked = triangle(index);
  const std::vector<std::uint32_t> near = meeting(index, *this);
  const auto found = std::find_if(near.begin(), near.end(), [&](std::uint32_t other) {
    return other != index && has_area(other) && narrowphase::meets_inside(triangle(other), asked);
  });
  const auto answer = found == near.end() ? std::nullopt : std::optional(*found);
  intruders_.emplace(index, answer);
  return answer;
}

// The triangle is taken as a mesh of its own, whose box lies along it: an axis-aligned one around a
// long slanted triangle meets most of a mesh of such.
std::vector<std::uint32_t> FaceSides::meeting(std::uint32_t index, const FaceSides& of) const {
  const Triangle own = placed_.mesh.triangle(index);
  const Mesh alone(std::vector{own.a, own.b, own.c}, std::vector<TriangleIndices>{{0, 1, 2}});
  const TrianglePairs pairs = find_triangle_pairs({alone, placed_.pose}, of.placed(), {}, &work_);
  std::vector<std::uint32_t> triangles;
  triangles.reserve(pairs.size());
  for (const TrianglePair& pair : pairs)
    triangles.push_back(pair.b);
  return triangles;
}

FaceSides::Enclosed FaceSides::enclosed(std::uint32_t index) {
  const auto known = enclosed_.find(index);
  if (known != enclosed_.end()) return known->second;
  const Triangle asked = triangle(index);
  const Enclosed answer{is_sample_enclosed(placed_, {asked, Sign::Positive}, work_),
                        is_sample_enclosed(placed_, {asked, Sign::Negative}, work_)};
  enclosed_.emplace(index, answer);
  return answer;
}

}  // namespace graze
