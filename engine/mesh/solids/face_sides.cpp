#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/solids/face_sides.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>
#include <graze/narrowphase/triangle_pair/inside_contact.h>

#include <algorithm>

namespace graze {

using narrowphase::Sign;

bool FaceSides::has_area(std::uint32_t index) const {
  return !narrowphase::is_degenerate(triangle(index));
}

std::optional<std::uint32_t> FaceSides::intruder(std::uint32_t index) {
  const auto known = intruders_.find(index);
  if (known != intruders_.end()) return known->second;
  const Triangle asked = triangle(index);
  const Aabb around{asked.a.cwiseMin(asked.b).cwiseMin(asked.c),
                    asked.a.cwiseMax(asked.b).cwiseMax(asked.c)};
  const TriangleList near = find_triangles(placed_, around, {}, &work_);
  const auto found = std::find_if(near.begin(), near.end(), [&](std::uint32_t other) {
    return other != index && has_area(other) && narrowphase::meets_inside(triangle(other), asked);
  });
  const auto answer = found == near.end() ? std::nullopt : std::optional(*found);
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
