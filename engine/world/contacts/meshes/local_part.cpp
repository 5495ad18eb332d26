#include <graze/engine/world/contacts/meshes/local_part.h>

#include <algorithm>

namespace graze {

using narrowphase::Vec3;

void LocalPart::start(const InnerSurface& surface, const PieceIndex& index, std::uint32_t piece,
                      std::uint32_t triangle, InnerSide side, double most_rise) {
  surface_ = &surface, index_ = &index;
  is_of_a_ = side == InnerSide::OfA;
  most_rise_ = most_rise, goes_on_ = false;
  part_.clear(), curve_point_.clear();
  part_.at = surface.part(piece).at;
  ++round_;
  point_round_.resize(std::max(point_round_.size(), index.point_count()));
  vertex_round_.resize(std::max(vertex_round_.size(), surface.vertex_count()));
  std::uint32_t last = 0xffffffffu;
  for (const std::uint32_t i : index.on_triangle(triangle, !is_of_a_)) {
    const MeshCrossing& crossing = index.crossings()[i];
    const std::uint32_t own = is_of_a_ ? crossing.pair.a : crossing.pair.b;
    if (own == last) continue;
    last = own;
    if (!add_corners(own, {}, -1)) add_ends(index.on_triangle_of(i, is_of_a_), {}, -1);
  }
}

void LocalPart::add_curve_point(std::uint32_t point, const Vec3& at) {
  if (point_round_[point] == round_) return;
  point_round_[point] = round_;
  part_.add(at - part_.at, InnerPart::kNoVertex, false);
  curve_point_.push_back(point);
}

void LocalPart::add_vertex(std::uint32_t vertex) {
  if (vertex_round_[vertex] == round_) return;
  vertex_round_[vertex] = round_;
  part_.add(surface_->placed(vertex) - part_.at, vertex, false);
  curve_point_.push_back(0);
}

/// Adds the corners of a triangle that are inside and lie beyond a height in a direction. True if
/// all are inside: then all that goes through the triangle does so between them, and lies no
/// farther.
bool LocalPart::add_corners(std::uint32_t own_triangle, const Vec3& direction, double above) {
  bool is_all_inside = true;
  for (const std::uint32_t vertex : surface_->corners(own_triangle)) {
    if (!surface_->is_inside(vertex)) {
      is_all_inside = false;
    } else if (vertex_round_[vertex] != round_ &&
               dot(surface_->placed(vertex) - part_.at, direction) > above) {
      add_vertex(vertex);
    }
  }
  return is_all_inside;
}

/// Adds the ends of crossings that lie beyond a height in a direction.
void LocalPart::add_ends(std::span<const std::uint32_t> crossings, const Vec3& direction,
                         double above) {
  const auto is_above = [&](const Vec3& point) { return dot(point - part_.at, direction) > above; };
  for (const std::uint32_t i : crossings) {
    const MeshCrossing& crossing = index_->crossings()[i];
    if (is_above(crossing.from))
      add_curve_point(crossing.from_number - index_->first_point(), crossing.from);
    if (is_above(crossing.to))
      add_curve_point(crossing.to_number - index_->first_point(), crossing.to);
  }
}

/// Adds the points inside that lie farther, of the triangles that meet in a point.
void LocalPart::go_on_inside(std::size_t point, const Vec3& direction) {
  const double above = dot(part_.points[point], direction);
  const std::uint32_t vertex = part_.vertex[point];
  if (vertex == InnerPart::kNoVertex) {
    std::uint32_t last = 0xffffffffu;
    for (const std::uint32_t i : index_->in_point(curve_point_[point])) {
      const TrianglePair& pair = index_->crossings()[i].pair;
      const std::uint32_t own = is_of_a_ ? pair.a : pair.b;
      if (own == last) continue;
      last = own;
      if (!add_corners(own, direction, above))
        add_ends(index_->on_triangle_of(i, is_of_a_), direction, above);
    }
  } else {
    for (const std::uint32_t triangle : surface_->around(vertex))
      if (!add_corners(triangle, direction, above))
        add_ends(index_->on_triangle(triangle, is_of_a_), direction, above);
  }
}

/// True if a triangle at a point rises beyond it, where that leads around the other mesh.
bool LocalPart::rises_outside(std::size_t point, const Vec3& direction) const {
  const double above =
      dot(part_.points[point], direction) + InnerSurface::kSameHeight * part_.radius;
  const auto rises = [&](std::uint32_t triangle) {
    for (const std::uint32_t corner : surface_->corners(triangle))
      if (dot(surface_->placed(corner) - part_.at, direction) > above) return true;
    return false;
  };
  const std::uint32_t vertex = part_.vertex[point];
  if (vertex != InnerPart::kNoVertex) {
    const std::span<const std::uint32_t> around = surface_->around(vertex);
    return std::any_of(around.begin(), around.end(), rises);
  }
  for (const std::uint32_t i : index_->in_point(curve_point_[point])) {
    const MeshCrossing& crossing = index_->crossings()[i];
    const Vec3& left = is_of_a_ ? crossing.normal_b : crossing.normal_a;
    if (InnerSurface::goes_around(left, direction) &&
        rises(is_of_a_ ? crossing.pair.a : crossing.pair.b))
      return true;
  }
  return false;
}

std::size_t LocalPart::grow(const Vec3& direction) {
  std::size_t best = part_.farthest(direction);
  double most = dot(part_.points[best], direction);
  const double end = most + most_rise_;
  for (;;) {
    const std::size_t before = part_.points.size(), last = best;
    go_on_inside(best, direction);
    for (std::size_t i = before; i < part_.points.size(); ++i) {
      const double along = dot(part_.points[i], direction);
      if (along > most) most = along, best = i;
    }
    if (best == last) break;
    if (most > end) {
      goes_on_ = true;
      return best;
    }
  }
  goes_on_ |= rises_outside(best, direction);
  return best;
}

}  // namespace graze
