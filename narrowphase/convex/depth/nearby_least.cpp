#include <graze/narrowphase/convex/depth/nearby_least.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace graze::narrowphase {
namespace {

// The search looks for edges to which the normal is at right angles within this angle, a few times
// what a polytope leaves it off.
constexpr double kAside = 0x1p-7;

// The sine of the angle beyond which nothing counts as nearby.
constexpr double kMostTurn = 0x1p-4;

// Newton's method comes from a thousandth to rounding in three steps.
constexpr int kMostSteps = 4;
constexpr double kSettled = 0x1p-44;

// A normal is not worse where the depth along it is larger by the first share of the scale, which
// is rounding alone, and points lie along it to the second.
constexpr double kRounding = 0x1p-48;
constexpr double kMeeting = 0x1p-36;

/// A line on a core's surface from end to end: an edge, or one on a round side.
struct Ridge {
  Vec3 from, direction;
  Vec3 unit() const { return unit_or(direction, {}); }
  explicit operator bool() const { return largest(direction) > 0; }
};

Vec3 across_axis(const Core& core, const Vec3& out) {
  return unit_or(out - core.axis[2] * dot(out, core.axis[2]), core.axis[0]);
}

/// Returns the line on the side of a cylinder, or from a cone's apex to its rim, where it looks
/// along a direction.
Ridge side_line(const Core& core, const Vec3& out) {
  const Vec3 up = core.axis[2] * core.half.z, aside = across_axis(core, out) * core.half.x;
  if (core.kind == CoreKind::Cone) return {core.at + up, aside - up * 2};
  return {core.at - up + aside, up * 2};
}

bool has_side_lines(const Core& core) {
  return core.kind == CoreKind::Cylinder || core.kind == CoreKind::Cone;
}

/// Returns the line of a core that may be farthest along `out` or beside it; `aside` is a direction
/// there.
Ridge ridge_near(const Core& core, const Vec3& out, const Vec3& aside) {
  if (core.kind == CoreKind::Point || core.kind == CoreKind::Ellipsoid) return {};
  if (!has_side_lines(core)) {
    const Vec3 end = support(core, out);
    return {end, support(core, aside) - end};
  }
  const Ridge line = side_line(core, out);
  return std::abs(dot(line.unit(), out)) < kAside ? line : Ridge{};
}

/// Returns the second derivative, for turns towards s and t, of how far a core reaches along `out`,
/// a unit direction: at its rim, if it has one.
double bend(const Core& core, const Vec3& out, const Vec3& s, const Vec3& t) {
  if (core.kind == CoreKind::Ellipsoid) {
    const auto stretched = [&](const Vec3& direction) {
      const Vec3 own = into_own(core, direction);
      return Vec3{core.half.x * own.x, core.half.y * own.y, core.half.z * own.z};
    };
    const Vec3 p = stretched(out), of_s = stretched(s), of_t = stretched(t);
    return (dot(of_s, of_t) - dot(p, of_s) * dot(p, of_t) / dot(p, p)) / length(p);
  }
  if (!has_side_lines(core)) return 0;
  const Vec3 radial = out - core.axis[2] * dot(out, core.axis[2]);
  const Vec3 across = cross(core.axis[2], radial);
  const double sine = length(radial);
  return core.half.x * dot(across, s) * dot(across, t) / (sine * sine * sine);
}

/// Returns the same where the core is farthest in one point.
double bend_of_end(const Core& core, const Vec3& out, const Vec3& s, const Vec3& t) {
  if (core.kind == CoreKind::Cone && dot(side_line(core, out).direction, out) < 0) return 0;
  return bend(core, out, s, t);
}

class NearbyLeast {
 public:
  NearbyLeast(const Core& a, const Core& b, Penetration& penetration)
      : a_(a), b_(b), best_(penetration), from_(penetration.normal) {
    limit_ = penetration.depth + kRounding * pair_scale(a, b);
  }

  void run() {
    const Vec3 apart = best_.point_a - best_.point_b;
    const Vec3 ahead = unit_or(apart - from_ * dot(apart, from_), {});
    const Vec3 aside = unit_or(from_ - ahead * kAside, from_);
    const Ridge of_a = ridge_near(a_, from_, aside), of_b = ridge_near(b_, -from_, -aside);
    if (of_a && of_b) offer_both(of_a, of_b);
    if (of_a) offer_on(a_, of_a);
    if (of_b) offer_on(b_, of_b);
    offer_on_rims();
  }

 private:
  /// Takes a normal along which the two are less deep, with its points.
  bool take(const Penetration& found) {
    if (!(dot(found.normal, from_) > 1 - kMostTurn * kMostTurn)) return false;
    if (!(found.depth < limit_ && found.depth >= 0)) return false;
    limit_ = best_.depth = found.depth;
    best_.normal = found.normal, best_.point_a = found.point_a, best_.point_b = found.point_b;
    best_.has_witnesses = false;
    return true;
  }

  void meet_at(const Vec3& on_a, const Vec3& on_b) {
    const Vec3 off = on_a - on_b - best_.normal * best_.depth;
    if (!(largest(off) <= kMeeting * pair_scale(a_, b_))) return;
    best_.point_a = on_a, best_.point_b = on_b, best_.has_witnesses = true;
  }

  static Ridge turned_to(const Core& core, const Ridge& ridge, const Vec3& out) {
    return has_side_lines(core) ? side_line(core, out) : ridge;
  }

  /// Offers the normals at right angles to a line of either; a cone's line turns with the normal.
  void offer_both(Ridge of_a, Ridge of_b) {
    Vec3 normal = from_;
    const bool turns = a_.kind == CoreKind::Cone || b_.kind == CoreKind::Cone;
    for (int i = 0; i < (turns ? kMostSteps : 1); ++i) {
      of_a = turned_to(a_, of_a, normal), of_b = turned_to(b_, of_b, -normal);
      const Vec3 next = unit_or(cross(of_a.unit(), of_b.unit()), {});
      if (!(largest(next) > 0)) return;
      normal = dot(next, from_) < 0 ? -next : next;
    }
    if (!take(along(a_, b_, normal))) return;
    of_a = turned_to(a_, of_a, normal), of_b = turned_to(b_, of_b, -normal);
    const Vec3 line_a = of_a.unit(), line_b = of_b.unit(), between = of_b.from - of_a.from;
    const Vec3 both = cross(line_a, line_b);
    const double square = dot(both, both);
    const double share_a = dot(cross(between, line_b), both) / square / length(of_a.direction);
    const double share_b = dot(cross(between, line_a), both) / square / length(of_b.direction);
    if (!is_share(share_a) || !is_share(share_b)) return;
    meet_at(of_a.from + of_a.direction * share_a, of_b.from + of_b.direction * share_b);
  }

  static bool is_share(double share) { return share >= 0 && share <= 1; }

  /// Offers the normals at right angles to a line of one of the two, which meets the other's
  /// farthest point.
  void offer_on(const Core& core, Ridge ridge) {
    const bool is_a = &core == &a_;
    const double sign = is_a ? 1 : -1;
    Vec3 normal = from_;
    for (int i = 0; i < kMostSteps; ++i) {
      ridge = turned_to(core, ridge, normal * sign);
      const Vec3 line = ridge.unit();
      normal = unit_or(normal - line * dot(normal, line), normal);
      const Vec3 turn = cross(line, normal);
      const Penetration at = along(a_, b_, normal);
      const double share = share_of(is_a ? at.point_b : at.point_a, ridge);
      // A cone is as round as it is wide there.
      const double width = core.kind == CoreKind::Cone ? std::clamp(share, 0.0, 1.0) : 1;
      const Core& other = is_a ? b_ : a_;
      const double bent = bend(core, normal * sign, turn, turn) * width +
                          bend_of_end(other, normal * -sign, turn, turn);
      if (!(bent > at.depth)) return;
      const double step = -dot(at.point_a - at.point_b, turn) / (bent - at.depth);
      if (!(std::abs(step) < kMostTurn)) return;
      normal = unit_or(normal + turn * step, normal);
      if (std::abs(step) < kSettled) break;
    }
    ridge = turned_to(core, ridge, normal * sign);
    normal = unit_or(normal - ridge.unit() * dot(normal, ridge.unit()), normal);
    const Penetration found = along(a_, b_, normal);
    if (!take(found)) return;
    ridge = turned_to(core, ridge, normal * sign);
    const double share = share_of(is_a ? found.point_b : found.point_a, ridge);
    if (!is_share(share)) return;
    const Vec3 on_ridge = ridge.from + ridge.direction * share;
    is_a ? meet_at(on_ridge, found.point_b) : meet_at(found.point_a, on_ridge);
  }

  /// Returns the share of a line where it is nearest to a point.
  static double share_of(const Vec3& point, const Ridge& ridge) {
    return dot(point - ridge.from, ridge.direction) / dot(ridge.direction, ridge.direction);
  }

  /// Offers the normal where both are farthest in one point.
  void offer_on_rims() {
    Vec3 normal = from_;
    for (int i = 0; i < kMostSteps; ++i) {
      const Penetration at = along(a_, b_, normal);
      const Vec3 apart = at.point_a - at.point_b;
      const Vec3 u = any_normal_to(normal), v = cross(normal, u);
      const auto bent = [&](const Vec3& s, const Vec3& t) {
        return bend_of_end(a_, normal, s, t) + bend_of_end(b_, -normal, s, t);
      };
      const double uu = bent(u, u) - at.depth, vv = bent(v, v) - at.depth, uv = bent(u, v);
      const double determinant = uu * vv - uv * uv;
      if (!(uu > 0 && determinant > 0)) return;
      const double of_u = -dot(apart, u), of_v = -dot(apart, v);
      const double by_u = (of_u * vv - of_v * uv) / determinant;
      const double by_v = (of_v * uu - of_u * uv) / determinant;
      if (!(std::abs(by_u) + std::abs(by_v) < kMostTurn)) return;
      normal = unit_or(normal + u * by_u + v * by_v, normal);
      if (std::abs(by_u) + std::abs(by_v) < kSettled) break;
    }
    const Penetration found = along(a_, b_, normal);
    if (take(found)) meet_at(found.point_a, found.point_b);
  }

  const Core& a_;
  const Core& b_;
  Penetration& best_;
  Vec3 from_;
  double limit_;
};

}  // namespace

bool has_bends(const Core& core) {
  return has_side_lines(core) || core.kind == CoreKind::Ellipsoid;
}

void turn_to_nearby_least(const Core& a, const Core& b, Penetration& penetration) {
  NearbyLeast(a, b, penetration).run();
}

}  // namespace graze::narrowphase
