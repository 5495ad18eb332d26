#include <graze/engine/compare/judge/rational/rational_ray.h>

#include <algorithm>

namespace graze::compare {
namespace {

using Meeting = std::optional<mpq_class>;

/// Returns, for a segment on one line with the ray, its first point that is not behind the origin.
Meeting first_on_line(const RationalRay& ray, const RationalPoint& from, const RationalPoint& to) {
  const mpq_class square = dot(ray.direction, ray.direction);
  const mpq_class s_from = dot(minus(from, ray.origin), ray.direction) / square;
  const mpq_class s_to = dot(minus(to, ray.origin), ray.direction) / square;
  if (s_from < 0 && s_to < 0) return std::nullopt;
  const mpq_class first = s_from < s_to ? s_from : s_to;
  return first < 0 ? mpq_class(0) : first;
}

Meeting first_on_segment(const RationalRay& ray, const RationalPoint& from,
                         const RationalPoint& to) {
  const RationalPoint side = minus(to, from);
  const RationalPoint offset = minus(from, ray.origin);
  const RationalPoint across = cross(ray.direction, side);
  if (is_zero(across)) {
    return is_zero(cross(offset, ray.direction)) ? first_on_line(ray, from, to) : std::nullopt;
  }
  if (dot(across, offset) != 0) return std::nullopt;
  const mpq_class square = dot(across, across);
  const mpq_class s = dot(cross(offset, side), across) / square;
  const mpq_class r = dot(cross(offset, ray.direction), across) / square;
  if (s < 0 || r < 0 || r > 1) return std::nullopt;
  return s;
}

Meeting first_in_plane(const RationalRay& ray, const RationalTriangle& t) {
  if (squared_distance(t, {ray.origin, ray.origin, ray.origin}) == 0) return mpq_class(0);
  Meeting first;
  for (std::size_t i = 0; i < 3; ++i) {
    const Meeting found = first_on_segment(ray, t[i], t[(i + 1) % 3]);
    if (found && (!first || *found < *first)) first = found;
  }
  return first;
}

}  // namespace

RationalPoint RationalRay::at(const mpq_class& s) const {
  return {origin[0] + s * direction[0], origin[1] + s * direction[1], origin[2] + s * direction[2]};
}

RationalRay exactly(const Ray& ray) {
  return {exactly(ray.origin), exactly(ray.direction)};
}

std::optional<mpq_class> first_meeting(const RationalRay& ray, const RationalTriangle& t) {
  const RationalPoint normal = cross(edge_of(t, 0), edge_of(t, 1));
  const mpq_class approach = dot(normal, ray.direction);
  const mpq_class height = dot(normal, minus(t[0], ray.origin));
  if (approach == 0) return height == 0 ? first_in_plane(ray, t) : std::nullopt;
  const mpq_class s = height / approach;
  if (s < 0) return std::nullopt;
  const RationalPoint point = ray.at(s);
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(normal, cross(edge_of(t, i), minus(point, t[i]))) < 0) return std::nullopt;
  }
  return s;
}

}  // namespace graze::compare
