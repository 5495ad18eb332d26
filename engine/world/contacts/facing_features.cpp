#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/data/vertex_fans.h>
#include <graze/engine/world/contacts/facing_features.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <cmath>

namespace graze {

using narrowphase::Core;
using narrowphase::DirectionArc;
using narrowphase::Vec3;

namespace {

// Triangles whose height is below this share of their longest edge have no meaningful normal.
constexpr double kSliver = 1e-7;

// Edges that turn by less than this, radians, are flat.
constexpr double kFlat = 1e-6;

// A corner faces a direction if that leads away from all its neighbours by more than this sine. A
// direction that leads to no neighbour but along an edge is faced by the edge, or by the face: from
// a corner of a straight edge, or of a flat face, a body is not led away along a normal of its own
// that leans by rounding.
constexpr double kFacedSine = 1e-6;

// A point that is beyond an edge by less than this share of its coordinates is on it.
constexpr double kOnEdge = 0x1p-44;

// The search looks across this many slivers in a row.
constexpr int kMostSlivers = 8;

Vec3 normal_of_plane(const Core& triangle) {
  const Vec3* corner = triangle.corner;
  return unit_or(cross(corner[1] - corner[0], corner[2] - corner[0]), {0, 0, 1});
}

/// True if a triangle is a sliver. It computes in units of the longest edge, as squares of areas
/// could leave the range of double.
bool is_thin(const Vec3& p, const Vec3& q, const Vec3& r) {
  const double longest = std::max({largest(q - p), largest(r - q), largest(p - r)});
  if (!(longest > 0)) return true;
  const Vec3 s = (q - p) * (1 / longest), t = (r - p) * (1 / longest);
  return !(length(cross(s, t)) > kSliver);
}

}  // namespace

class FacingFeatures::Narrowing {
 public:
  Narrowing(const Vec3& corner, const DirectionArc& arc) : corner_(corner), arc_(arc) {}

  /// Narrows the arc to directions that `point`, of a triangle beside the edge, is not ahead in.
  void add(const Vec3& point) {
    const Vec3 offset = point - corner_;
    double down = -dot(offset, arc_.first);
    const double out = dot(offset, arc_.aside);
    if (std::abs(down) <= kFlat * std::abs(out)) down = 0;
    narrow_to(out, down);
    has_neighbour_ = true;
  }
  /// Narrows the angle to that whose cosine and sine have the ratio of these two.
  void narrow_to(double cosine, double sine) {
    const double size = std::max(std::abs(cosine), std::abs(sine));
    if (!(size > 0)) return;
    const double share =
        1 / std::sqrt((cosine / size) * (cosine / size) + (sine / size) * (sine / size));
    cosine = cosine / size * share, sine = sine / size * share;
    if (sine < 0) cosine = 1, sine = 0;
    // Of two angles up to half a turn, the one with the greater cosine is smaller.
    if (cosine > arc_.cosine) arc_.cosine = cosine, arc_.sine = sine;
  }
  void note_neighbour() { has_neighbour_ = true; }

  const Vec3& corner() const { return corner_; }
  bool has_neighbour() const { return has_neighbour_; }
  const DirectionArc& arc() const { return arc_; }

 private:
  Vec3 corner_;
  DirectionArc arc_;
  bool has_neighbour_ = false;
};

FacingFeatures::FacingFeatures(const PlacedMeshView& mesh, const Vec3& origin)
    : mesh_(mesh),
      placing_(placing_of(mesh, origin)),
      welded_(mesh.mesh.welded()),
      triangles_(mesh.mesh.triangles()),
      fans_(vertex_fans_of(mesh.mesh)) {}

bool FacingFeatures::is_sliver(const Core& triangle) {
  return is_thin(triangle.corner[0], triangle.corner[1], triangle.corner[2]);
}

Vec3 FacingFeatures::placed(std::uint32_t vertex) const {
  return placed_vertex(placing_, vertex);
}

Core FacingFeatures::placed_triangle(std::uint32_t index) const {
  return core_of(placed_corners(placing_, index));
}

/// From each triangle the search goes on over the edge that the point is farthest beyond.
std::optional<std::uint32_t> FacingFeatures::flat_triangle(std::uint32_t index, const Core& first,
                                                           const Vec3& point) const {
  const FlatWay way = flat_way(index, first, point);
  if (!way.has_point) return std::nullopt;
  return way.last;
}

bool FacingFeatures::falls_back(std::uint32_t index, const Core& first, const Vec3& point) const {
  const std::optional<std::uint32_t> beyond = flat_way(index, first, point).beyond;
  if (!beyond) return false;
  const Core other = placed_triangle(*beyond);
  const Vec3 normal = normal_of_plane(first);
  // Two of its corners are in the plane, to rounding, and the third is farther from it.
  double lowest = 0, highest = 0;
  for (const Vec3& corner : other.corner) {
    const double above = dot(normal, corner - first.corner[0]);
    lowest = std::min(lowest, above), highest = std::max(highest, above);
  }
  return -lowest > highest;
}

FacingFeatures::FlatWay FacingFeatures::flat_way(std::uint32_t index, const Core& first,
                                                 const Vec3& point) const {
  constexpr int kMostSteps = 64;
  const Vec3 normal = normal_of_plane(first);
  // A point on an edge is in both of its triangles, and not beyond the edge of either.
  const double rounding = kOnEdge * (largest(point) + largest(first.corner[0]));
  Core triangle = first;
  for (int step = 0; step < kMostSteps; ++step) {
    int beyond = -1;
    double most = rounding;
    for (int k = 0; k < 3; ++k) {
      const Vec3 along = triangle.corner[(k + 1) % 3] - triangle.corner[k];
      const double out = dot(unit_or(cross(along, normal), normal), point - triangle.corner[k]);
      if (out > most) beyond = k, most = out;
    }
    if (beyond < 0) return {index, true, {}};
    const std::optional<std::uint32_t> next =
        neighbour(vertex(index, beyond), vertex(index, (beyond + 1) % 3), index);
    if (!next) return {index, false, {}};
    const Core other = placed_triangle(*next);
    const Vec3* corner = other.corner;
    const Vec3 turned = unit_or(cross(corner[1] - corner[0], corner[2] - corner[0]), {});
    if (!(dot(turned, normal) > 0) || length(cross(turned, normal)) > kFlat)
      return {index, false, next};
    index = *next, triangle = other;
  }
  return {index, false, {}};
}

std::optional<std::uint32_t> FacingFeatures::neighbour(std::uint32_t s, std::uint32_t t,
                                                       std::uint32_t without) const {
  for (const std::uint32_t index : fans_.around(s)) {
    if (index == without) continue;
    for (int k = 0; k < 3; ++k) {
      if (vertex(index, k) == t) return index;
    }
  }
  return std::nullopt;
}

std::optional<std::uint32_t> FacingFeatures::across(std::uint32_t index, int k) const {
  return neighbour(vertex(index, k), vertex(index, (k + 1) % 3), index);
}

std::span<const std::uint32_t> FacingFeatures::fan(std::uint32_t vertex) const {
  return fans_.around(vertex);
}

std::uint32_t FacingFeatures::vertex(std::uint32_t index, int k) const {
  return welded_[triangles_[index][static_cast<std::size_t>(k)]];
}

/// Goes through the triangles beside the edge from `low` to `high`, except `without`, and through
/// those beyond a sliver.
void FacingFeatures::narrow(Narrowing& narrowing, const End& low, const End& high,
                            std::uint32_t without, int depth) const {
  std::span<const std::uint32_t> fan = fans_.around(low.vertex);
  if (fans_.around(high.vertex).size() < fan.size()) fan = fans_.around(high.vertex);
  std::uint32_t before = without;
  for (const std::uint32_t index : fan) {
    if (index == without || index == before) continue;
    before = index;
    std::uint32_t of[3];
    for (int i = 0; i < 3; ++i)
      of[i] = vertex(index, i);
    const bool has_low = of[0] == low.vertex || of[1] == low.vertex || of[2] == low.vertex;
    const bool has_high = of[0] == high.vertex || of[1] == high.vertex || of[2] == high.vertex;
    if (!has_low || !has_high) continue;
    for (const std::uint32_t third : of) {
      if (third == low.vertex || third == high.vertex) continue;
      const End beside{third, placed(third)};
      if (!is_thin(low.point, high.point, beside.point)) {
        narrowing.add(beside.point);
      } else if (depth < kMostSlivers) {
        narrowing.note_neighbour();
        for (const End* end : {&low, &high}) {
          const bool is_first = end->vertex < third;
          narrow(narrowing, is_first ? *end : beside, is_first ? beside : *end, index, depth + 1);
        }
      }
    }
  }
}

std::optional<DirectionArc> FacingFeatures::arc(std::uint32_t index, int k, const Core& triangle,
                                                const Vec3& normal) const {
  const int next = (k + 1) % 3;
  const Vec3 along = triangle.corner[next] - triangle.corner[k];
  const Vec3 aside = unit_or(cross(along, normal), normal);
  Narrowing narrowing(triangle.corner[k], {normal, aside, -1, 0});
  const End s{vertex(index, k), triangle.corner[k]}, t{vertex(index, next), triangle.corner[next]};
  const bool is_first = s.vertex < t.vertex;
  narrow(narrowing, is_first ? s : t, is_first ? t : s, index, 0);
  DirectionArc arc = narrowing.arc();
  if (!narrowing.has_neighbour()) arc.cosine = 0, arc.sine = 1;
  if (arc.cosine > 0 && arc.sine < kFlat) return std::nullopt;
  return arc;
}

bool FacingFeatures::corner_faces(std::uint32_t index, int k, const Vec3& direction) const {
  const std::uint32_t of = vertex(index, k);
  constexpr std::size_t kMany = 16;
  if (fans_.around(of).size() < kMany) return vertex_faces(of, direction);
  AskedCorner& asked = asked_[of % asked_.size()];
  if (asked.vertex != of || largest(asked.direction - direction) != 0)
    asked = {of, direction, vertex_faces(of, direction)};
  return asked.is_faced;
}

bool FacingFeatures::vertex_faces(std::uint32_t of, const Vec3& direction) const {
  // In the mesh's own frame nothing needs to be placed.
  const double* m = mesh_.pose.data();
  const Vec3 own{dot({m[0], m[1], m[2]}, direction), dot({m[4], m[5], m[6]}, direction),
                 dot({m[8], m[9], m[10]}, direction)};
  const Vec3 corner = to_vec3(placing_.vertices[of]);
  for (const std::uint32_t other : fans_.around(of)) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t end = vertex(other, i);
      if (end == of) continue;
      const Vec3 edge = to_vec3(placing_.vertices[end]) - corner;
      const double ahead = dot(own, edge);
      if (!(ahead < 0) || ahead * ahead <= kFacedSine * kFacedSine * dot(edge, edge)) return false;
    }
  }
  return true;
}

}  // namespace graze
