#include <graze/narrowphase/convex/contact/meeting_points.h>
#include <graze/narrowphase/convex/core/core_ray.h>
#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <optional>

namespace graze::narrowphase {
namespace {

// A set is far larger than another whose size is less than the first share of its own. Points that
// are nearer to the surface than the second share of the scale are on it, and a point further away
// belongs to another part of it.
constexpr double kFarLarger = 0x1p-16;
constexpr double kOnSurface = 0x1p-34;
constexpr double kNearEnough = 0x1p-30;

/// A share of the scale that is well above the rounding of points and gaps.
constexpr double kBeyondRounding = 0x1p-40;

Core shifted(Core core, const Vec3& by) {
  core.at = core.at + by;
  for (Vec3& corner : core.corner)
    corner = corner + by;
  return core;
}

/// Returns the outermost point of a set on the line through a point along a unit direction; nothing
/// if the line misses the set, or the set is a triangle or points of which no hull is known.
std::optional<Vec3> end_on_line(const Core& core, const Vec3& point, const Vec3& out) {
  if (core.kind == CoreKind::Triangle) return std::nullopt;
  if (core.kind == CoreKind::Points && core.hull == nullptr) return std::nullopt;
  const Vec3 start =
      point + out * (dot(core.at - point, out) + 2 * (core.bounding_radius + core.radius));
  const std::optional<CoreRayHit> hit = cast_ray(core, start, -out);
  if (!hit) return std::nullopt;
  return start - out * hit->distance;
}

/// Returns the farthest point of one of the two sets along a normal from A to B, and where the line
/// through it leaves the other set; if the line misses that, the point at hand stays.
MeetingPoints of_farthest(const Core& a, const Core& b, bool is_of_a, const Vec3& normal,
                          MeetingPoints met) {
  Vec3& farthest = is_of_a ? met.on_a : met.on_b;
  Vec3& other = is_of_a ? met.on_b : met.on_a;
  farthest = is_of_a ? rounded_support(a, normal) : rounded_support(b, -normal);
  const std::optional<Vec3> end =
      end_on_line(is_of_a ? b : a, farthest, is_of_a ? -normal : normal);
  if (end) other = *end;
  return met;
}

bool is_smaller(const Core& a, const Core& b) {
  return a.bounding_radius + a.radius < b.bounding_radius + b.radius;
}

/// Describes the side of a capsule, a cylinder or a cone beside the line of it that faces a normal.
class RoundSide {
 public:
  RoundSide(const FaceOf& of, const Vec3& normal)
      : from_(of.face.corner[0]), line_(of.face.corner[1] - from_) {
    const Vec3& axis = of.core.axis[2];
    radial_ = unit_or(of.face.normal - axis * dot(of.face.normal, axis), of.face.normal);
    low_ = of.core.kind == CoreKind::Segment ? of.core.radius : of.core.half.x;
    high_ = of.core.kind == CoreKind::Cone ? 0 : low_;
    across_ = unit_or(cross(normal, line_), normal);
    ahead_ = cross(across_, normal);
  }

  double middle_radius() const { return 0.5 * (low_ + high_); }
  const Vec3& across() const { return across_; }
  double off(const Vec3& point) const { return dot(across_, point - from_); }

  /// Finds where the surface is on the line through a point along the normal, or at its end if it
  /// ends before that; false if the line passes the side by. That far off its own line a round
  /// section is lower by its drop, which on a side that leans is another section's. A cylinder's or
  /// a capsule's is as round; of a cone the third is nearly the same.
  bool end_beside(const Vec3& point, Vec3& end) const {
    const Vec3 offset = point - from_;
    const double off = dot(across_, offset);
    const double run = dot(line_, ahead_);
    double share = dot(offset, ahead_) / run;
    double drop = 0;
    for (int i = low_ == high_ ? 1 : 3; i >= 0; --i) {
      share = std::clamp(share, 0.0, 1.0);
      if (i > 0 || low_ != high_) {
        const double radius = low_ + (high_ - low_) * share;
        if (!(std::abs(off) < radius)) return false;
        drop = off * off / (radius + std::sqrt(radius * radius - off * off));
      }
      if (i > 0) share = dot(offset + radial_ * drop, ahead_) / run;
    }
    end = from_ + line_ * share + across_ * off - radial_ * drop;
    return true;
  }

  /// Returns how far a point is from the line through another along the normal, in the side's
  /// direction.
  double ahead(const Vec3& end, const Vec3& point) const { return dot(end - point, ahead_); }
  Vec3 moved(const Vec3& point, double ahead) const { return point + ahead_ * ahead; }

 private:
  Vec3 from_, line_;
  Vec3 radial_;
  double low_, high_;  ///< radii at the two ends
  Vec3 across_;        ///< unit, at right angles to the normal and the line
  Vec3 ahead_;         ///< unit, at right angles to the normal, nearly along the line
};

}  // namespace

double smaller_size(const Core& a, const Core& b) {
  return std::min(a.bounding_radius + a.radius, b.bounding_radius + b.radius);
}

bool lie_along(const Penetration& penetration, double tolerance) {
  return length(cross(penetration.point_a - penetration.point_b, penetration.normal)) <= tolerance;
}

namespace {

// Moved out by the depth and a clearance, the two are nowhere nearer than the clearance, and
// somewhere no further apart than that plus the excess of the depth over the least. So are their
// nearest points, along the normal, and across it as a leg of that triangle: 2^-17 of the smaller
// size at most, of the wider clearance.
//
// A core's point that is nearest to another core is as far from a plane that supports the first as
// the gap's bounds are from each other, if that plane is the one of the lower bound. Moved out
// along its normal it stays so, whatever the radius; the line between the points would turn it.
//
// That near, a search about round sets may end open, and a wider clearance may help. Else the
// points are moved along the normal, to where the line through one of them leaves each set: unless
// that is far from where they are, as where the line lies in a face. Where one set is so small that
// rounding of the other's points is more than any clearance, what was found is within that of both
// surfaces as well.
MeetingPoints by_clearance(const Core& a, const Core& b, const Penetration& penetration) {
  const double size = smaller_size(a, b);
  MeetingPoints met;
  for (const double clearance : {kClearance * size, 16 * kClearance * size}) {
    const Vec3 out = penetration.normal * (penetration.depth + clearance);
    const CoreGap gap = nearest(a, shifted(b, out));
    const Vec3& normal = gap.lower > 0 ? gap.normal : penetration.normal;
    met = {gap.point_a + normal * a.radius, gap.point_b - normal * b.radius - out};
    if (gap.verdict == GapVerdict::Apart) return met;
  }
  if (kBeyondRounding * pair_scale(a, b) > 16 * kClearance * size) return met;
  const Vec3 on_line = met.on_b;
  const auto move_to_surface = [&](const Core& core, const Vec3& normal, Vec3& point) {
    const std::optional<Vec3> end = end_on_line(core, on_line, normal);
    if (end && length(*end - point) < 64 * kClearance * size) point = *end;
  };
  move_to_surface(a, penetration.normal, met.on_a);
  move_to_surface(b, -penetration.normal, met.on_b);
  return met;
}

/// Returns how far the vector from B's point to A's is from the penetration.
double off_penetration(const MeetingPoints& met, const Penetration& penetration) {
  return length(met.on_a - met.on_b - penetration.normal * penetration.depth);
}

/// Moves the point of the smaller set along the normal to where its surface is. Beside a partner
/// that is so much larger a search may end with points that are known to its share of the scale
/// alone, which is a good deal of the smaller set.
void put_on_surface(const Core& core, bool is_a, const Vec3& normal, double scale,
                    MeetingPoints& met) {
  Vec3& point = is_a ? met.on_a : met.on_b;
  const std::optional<Vec3> end = end_on_line(core, point, is_a ? normal : -normal);
  if (!end) return;
  const double off = length(*end - point);
  if (off > kOnSurface * scale && off < kNearEnough * scale) point = *end;
}

}  // namespace

// A clearance that the bounds of a search hardly tell from nothing may end beside where the two
// meet, as of a set a millionth of the other's size in the side of a cone; and of a face on a tip
// a farthest corner is beside it. Then the best of the farthest points of both is taken.
MeetingPoints meeting_points(const Core& a, const Core& b, const Penetration& penetration) {
  MeetingPoints met = by_clearance(a, b, penetration);
  double off = off_penetration(met, penetration);
  const bool is_a_first = is_smaller(a, b);
  for (const bool is_of_a : {is_a_first, !is_a_first}) {
    if (off <= kMostAside * smaller_size(a, b)) break;
    const MeetingPoints other = of_farthest(a, b, is_of_a, penetration.normal, met);
    const double its = off_penetration(other, penetration);
    if (its < off) met = other, off = its;
  }
  if (kFarLarger * pair_scale(a, b) > smaller_size(a, b))
    put_on_surface(is_a_first ? a : b, is_a_first, penetration.normal, pair_scale(a, b), met);
  return met;
}

std::optional<MeetingPoints> ends_on_line(const Core& a, const Core& b, const Vec3& normal,
                                          const MeetingPoints& met) {
  std::optional<MeetingPoints> best;
  const auto offer = [&](const MeetingPoints& ends) {
    if (!best || dot(ends.on_a - ends.on_b, normal) > dot(best->on_a - best->on_b, normal))
      best = ends;
  };
  if (const std::optional<Vec3> end = end_on_line(b, met.on_a, -normal)) offer({met.on_a, *end});
  if (const std::optional<Vec3> end = end_on_line(a, met.on_b, normal)) offer({*end, met.on_b});
  return best;
}

// Corners of one plane are off it by 24 u of the bounding radius, as hull_ray.cpp adds up, and that
// is less than kBeyondRounding of it.
bool is_uneven(const FaceOf& of) {
  return of.face.unevenness > kBeyondRounding * of.core.bounding_radius;
}

// A line through an edge of the polygon may miss the hull by rounding. One that is kBeyondRounding
// of the bounding radius nearer to the middle of the face does not, and the surface is as near
// there as at the edge but for eight times that, as no facet of the face leans by more than 8
// degrees.
std::optional<Vec3> onto_surface(const FaceOf& of, const Vec3& point, const Vec3& out) {
  if (!is_uneven(of)) return point;
  const Core& core = of.core;
  const double rounding = kBeyondRounding * core.bounding_radius;
  Core bare = core;
  bare.radius = 0;
  const Vec3 below = point - out * (core.radius / dot(of.face.normal, out));
  Vec3 middle{0, 0, 0};
  for (int i = 0; i < of.face.count; ++i)
    middle = middle + of.face.corner[i] * (1.0 / of.face.count);
  const Vec3 inward = unit_or(middle - point, out);
  for (const Vec3& start : {below, below + inward * rounding}) {
    const std::optional<Vec3> end = end_on_line(bare, start, out);
    if (end) return point + out * dot(*end - below, out);
  }
  return std::nullopt;
}

// The polygon is asked by triangles, as the normal of a needle says little about where its far end
// is.
bool lies_on(const FaceOf& of, const Vec3& point, double within) {
  if (is_uneven(of)) return true;
  const ContactFace& face = of.face;
  const Vec3* corner = face.corner;
  if (face.count == 2)
    return length(nearest_on_segment(corner[0], corner[1], point) - point) <= within;
  Core triangle;
  triangle.kind = CoreKind::Triangle;
  for (int i = 2; i < face.count; ++i) {
    triangle.corner[0] = corner[0], triangle.corner[1] = corner[i - 1];
    triangle.corner[2] = corner[i];
    if (length(nearest_on_triangle(triangle, point) - point) <= within) return true;
  }
  return false;
}

bool move_to_deepest(const FaceOf& incident, const FaceOf& reference, double sign, double touching,
                     ContactPoint& contact) {
  const RoundSide met_side(reference, contact.normal), own_side(incident, contact.normal);
  const double off = met_side.off(contact.point_a);
  if (!(std::abs(off) > touching)) return true;
  const double radius = own_side.middle_radius();
  const double share = radius / (radius + met_side.middle_radius());
  Vec3 point = contact.point_a - met_side.across() * (off * share);
  Vec3 met, own;
  for (int i = 0; i < 3; ++i) {
    if (!met_side.end_beside(point, met) || !own_side.end_beside(point, own)) return false;
    // Past the end of a side that leans both points step back.
    const double of_met = met_side.ahead(met, point), of_own = met_side.ahead(own, point);
    const double most = std::abs(of_met) > std::abs(of_own) ? of_met : of_own;
    if (!(std::abs(most) > touching)) break;
    point = met_side.moved(point, most);
  }
  contact.point_a = sign > 0 ? met : own;
  contact.point_b = sign > 0 ? own : met;
  contact.depth = dot(contact.point_a - contact.point_b, contact.normal);
  return true;
}

}  // namespace graze::narrowphase
