#include <graze/narrowphase/convex/core/hull.h>
#include <graze/narrowphase/convex/depth/aligned_parting.h>
#include <graze/narrowphase/convex/depth/expanding_polytope.h>
#include <graze/narrowphase/convex/depth/nearby_least.h>
#include <graze/narrowphase/convex/depth/penetration.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

namespace graze::narrowphase {
namespace {

// These numbers govern how a depth is refined: the tangent of the first tilt and that below which
// no more is gained, how many directions are tried with each, and how often.
constexpr double kMostTilt = 0x1p-2;
constexpr double kLeastTilt = 0x1p-14;
constexpr int kTiltsOfRound = 8;
constexpr int kMostRounds = 48;

/// Returns the fixed direction of the least width: among the line between the middles and the axes
/// of both.
Penetration best_of_fixed(const Core& a, const Core& b) {
  const Vec3 between = unit_or(b.at - a.at, {0, 0, 1});
  Penetration best = along(a, b, between);
  const auto offer = [&](const Vec3& direction) {
    const Penetration found = along(a, b, unit_or(direction, between));
    if (found.depth < best.depth) best = found;
  };
  for (const Core* core : {&a, &b}) {
    for (const Vec3& axis : core->axis) {
      offer(axis);
      offer(-axis);
    }
  }
  best.source = PenetrationSource::Fixed;
  return best;
}

bool is_thin(const Core& core) {
  return core.kind == CoreKind::Point || core.kind == CoreKind::Segment;
}

/// The difference of two points or segments is flat: at right angles to it only the radii overlap,
/// and nowhere do they overlap less than that. No polytope could close around it.
Penetration out_of_plane(const Core& a, const Core& b) {
  Penetration best = best_of_fixed(a, b);
  const Vec3 across = unit_or(cross(a.axis[2], b.axis[2]), best.normal);
  for (const Vec3& normal : {across, -across}) {
    Penetration found = along(a, b, normal);
    found.source = PenetrationSource::Fixed;
    if (found.depth < best.depth) best = found;
  }
  return best;
}

/// Radii add the same to the width along any direction, so the polytope is that of the cores alone,
/// which is flat where that of the sets is round. Cores whose difference has no volume are asked
/// about with their radii.
PolytopeDepth polytope_of_cores(const Core& a, const Core& b, double tolerance) {
  const double radii = a.radius + b.radius;
  if (radii > 0) {
    Core bare_a = a, bare_b = b;
    bare_a.radius = bare_b.radius = 0;
    PolytopeDepth found = polytope_depth(bare_a, bare_b, tolerance);
    found.upper += radii;
    found.lower += radii;
    if (found.is_closed) return found;
  }
  return polytope_depth(a, b, tolerance);
}

/// Holds the directions of the edges of a box and of a hull of few edges; other sets have none.
class EdgeDirections {
 public:
  explicit EdgeDirections(const Core& core) {
    if (core.kind == CoreKind::Box) {
      for (const Vec3& axis : core.axis)
        edge_[count_++] = axis;
    }
    if (core.kind != CoreKind::Points || core.hull->contact_loops.size() > 2 * kMost) return;
    for (const Hull::Face& face : core.hull->contact_faces) {
      for (std::uint32_t i = 0; i < face.count; ++i) {
        const std::uint32_t from = core.hull->contact_loops[face.first + i];
        const std::uint32_t to = core.hull->contact_loops[face.first + (i + 1) % face.count];
        if (from > to || count_ == kMost) continue;  // the face beyond has it the other way round
        edge_[count_++] = turned(core, core.hull->corners[to] - core.hull->corners[from]);
      }
    }
  }
  const Vec3* begin() const { return edge_; }
  const Vec3* end() const { return edge_ + count_; }

 private:
  static constexpr std::size_t kMost = 24;
  Vec3 edge_[kMost];
  std::size_t count_ = 0;
};

/// Finds what parts two sets where no polytope closes: it takes the few shortest ways out of many
/// directions and tilts each to all sides, by half as much whenever no tilt makes it shorter. A way
/// out that is not proved to be the least need not be far from it.
class ShortestExits {
 public:
  ShortestExits(const Core& a, const Core& b) : a_(a), b_(b) {}

  void offer(const Vec3& unit_direction, PenetrationSource source) {
    Penetration offered = along(a_, b_, unit_direction);
    offered.source = source;
    for (Penetration& kept : kept_) {
      if (offered.depth < kept.depth) std::swap(offered, kept);
    }
  }

  /// Offers the axes and the faces of both, and the directions at right angles to edges of both.
  void offer_fixed() {
    const Vec3 between = unit_or(b_.at - a_.at, {0, 0, 1});
    offer(between, PenetrationSource::Fixed);
    offer_fixed(a_, 1, between);
    offer_fixed(b_, -1, between);
    EdgeDirections of_a(a_), of_b(b_);
    for (const Vec3& edge_a : of_a) {
      for (const Vec3& edge_b : of_b) {
        const Vec3 normal = unit_or(cross(edge_a, edge_b), between);
        offer(normal, PenetrationSource::Fixed);
        offer(-normal, PenetrationSource::Fixed);
      }
    }
  }

  Penetration least() const {
    Penetration best = kept_[0];
    for (const Penetration& kept : kept_) {
      const Penetration found = refined(kept);
      if (found.depth < best.depth) best = found;
    }
    return best;
  }

 private:
  static constexpr int kKept = 6;
  static constexpr std::size_t kMostFaces = 64;

  void offer_fixed(const Core& core, double sign, const Vec3& otherwise) {
    for (const Vec3& axis : core.axis) {
      offer(unit_or(axis, otherwise), PenetrationSource::Fixed);
      offer(unit_or(-axis, otherwise), PenetrationSource::Fixed);
    }
    if (core.kind != CoreKind::Points) return;
    const std::size_t count = std::min(core.hull->contact_faces.size(), kMostFaces);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 normal = turned(core, core.hull->contact_faces[i].normal) * sign;
      offer(unit_or(normal, otherwise), PenetrationSource::Fixed);
    }
  }

  Penetration refined(Penetration best) const {
    if (!std::isfinite(best.depth)) return best;
    double ahead = 1, aside = 0;  // each turned on by as much as 3 + 4i is, which never comes round
    double tilt = kMostTilt;
    for (int round = 0; round < kMostRounds && tilt > kLeastTilt; ++round) {
      const Vec3 base = best.normal;
      const Vec3 side = any_normal_to(base);
      const Vec3 across = cross(base, side);
      const double before = best.depth;
      for (int i = 0; i < kTiltsOfRound; ++i) {
        const Vec3 tilted = base + (side * ahead + across * aside) * tilt;
        Penetration found = along(a_, b_, unit_or(tilted, base));
        found.source = best.source;
        if (found.depth < best.depth) best = found;
        const double turned = 0.6 * ahead - 0.8 * aside;
        aside = 0.8 * ahead + 0.6 * aside;
        ahead = turned;
      }
      if (!(best.depth < before)) tilt *= 0.5;
    }
    return best;
  }

  const Core& a_;
  const Core& b_;
  Penetration kept_[kKept] = {none(), none(), none(), none(), none(), none()};

  static Penetration none() {
    Penetration penetration{};
    penetration.depth = std::numeric_limits<double>::infinity();
    return penetration;
  }
};

}  // namespace

Penetration along(const Core& a, const Core& b, const Vec3& unit_direction) {
  Penetration result{};
  result.normal = unit_direction;
  result.point_a = rounded_support(a, unit_direction);
  result.point_b = rounded_support(b, -unit_direction);
  result.depth = dot(result.point_a - result.point_b, unit_direction);
  return result;
}

double depth_tolerance(const Core& a, const Core& b) {
  const double size_a = a.bounding_radius + a.radius;
  const double size_b = b.bounding_radius + b.radius;
  return kDepthTolerance * (size_a < size_b ? size_a : size_b) + kDepthRounding * pair_scale(a, b);
}

Penetration penetration(const Core& a, const Core& b) {
  const double tolerance = depth_tolerance(a, b);
  if (is_thin(a) && is_thin(b)) {
    Penetration result = out_of_plane(a, b);
    result.lower = a.radius + b.radius;
    result.is_open = !(result.depth - (a.radius + b.radius) <= tolerance);
    return result;
  }
  if (const std::optional<Penetration> known = part_aligned(a, b, tolerance)) return *known;
  const PolytopeDepth found = polytope_of_cores(a, b, tolerance);
  // A polytope may close without a normal if one of the sets is lost in the rounding of the other.
  if (found.is_closed && largest(found.normal) > 0) {
    Penetration result = along(a, b, found.normal);
    result.source = PenetrationSource::Polytope;
    result.lower = found.lower;
    if (has_bends(a) || has_bends(b)) turn_to_nearby_least(a, b, result);
    return result;
  }
  ShortestExits exits(a, b);
  exits.offer_fixed();
  if (largest(found.normal) > 0) exits.offer(found.normal, PenetrationSource::Polytope);
  if (const std::optional<Vec3> direction = ask_ccd(a, b))
    exits.offer(*direction, PenetrationSource::Ccd);
  Penetration result = exits.least();
  result.lower = found.lower;
  // The polytope may be torn and its best plane still be good enough.
  result.is_open = !(result.depth - found.lower <= tolerance);
  return result;
}

}  // namespace graze::narrowphase
