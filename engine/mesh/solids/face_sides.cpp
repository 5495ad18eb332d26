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
  // As a mesh of its own, whose box lies along it: an axis-aligned one around a long slanted
  // triangle meets most of a mesh of such.
  const Triangle own = placed_.mesh.triangle(index), asked = triangle(index);
  const Mesh alone(std::vector{own.a, own.b, own.c}, std::vector<TriangleIndices>{{0, 1, 2}});
  const TrianglePairs near = find_triangle_pairs({alone, placed_.pose}, placed_, {}, &work_);
  const auto found = std::find_if(near.begin(), near.end(), [&](const TrianglePair& pair) {
    return pair.b != index && has_area(pair.b) &&
           narrowphase::meets_inside(triangle(pair.b), asked);
  });
  const auto answer = found == near.end() ? std::nullopt : std::optional(found->b);
  intruders_.emplace(index, answer);
  return answer;
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
